"""Who is in a script: the cast of a screenplay, and of a story in prose."""
