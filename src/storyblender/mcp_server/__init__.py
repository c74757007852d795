"""A door for agents: a held session as a server of the Model Context Protocol."""
