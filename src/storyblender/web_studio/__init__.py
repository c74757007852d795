"""The studio in a browser: a server on this machine only, over one open project."""
