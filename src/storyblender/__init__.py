"""StoryBlender: from a script to an editable 3D storyboard."""

__version__ = "0.1.0"
