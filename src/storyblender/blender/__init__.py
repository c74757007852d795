"""The only package that imports bpy. Run as ``python -m storyblender.blender`` it is the engine's worker."""
