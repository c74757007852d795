"""Characters from the user's files: a humanoid mesh is fitted with our body and bound to our skeleton."""
