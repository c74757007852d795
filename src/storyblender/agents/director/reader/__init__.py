"""The rule-based reader of the Director."""

from storyblender.agents.director.reader.reader import read_script

__all__ = ["read_script"]
