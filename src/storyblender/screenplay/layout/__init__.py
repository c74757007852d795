"""Pages in their writer's own layout: detects the kind of page, and turns its lines into screenplay elements."""
