"""Motion clips of the user: read from BVH and FBX files, brought onto our skeleton, found by what they are called."""
