"""A folder of scripts and projects with one open session, and what agents and the page are told of it."""
