"""The client side of Blender: worker processes, MCP client, supervisor, pool."""
