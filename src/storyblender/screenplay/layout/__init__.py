"""Pages in their writer's own layout: what kind of page it is, and its lines as the elements of a screenplay."""
