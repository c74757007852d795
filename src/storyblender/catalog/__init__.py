"""What the built-in library can make: names, tags, sizes, parameters, plans. Data and pure functions, no bpy."""
