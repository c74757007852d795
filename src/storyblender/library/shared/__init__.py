"""The user's library: what stories brought in, kept once and shared by all projects and processes of a user."""
