"""What a model of the user may cost: more than this is refused with one sentence, before Blender sees it."""

from __future__ import annotations

from storyblender.model_content import MOST_BYTES

MIB = 1 << 20
FILE_BYTES = MOST_BYTES
"""Of a model, and of all that it names together."""
TEXT_BYTES = 96 * MIB
"""Of a text format, .obj or .mtl, which is read line by line."""
JSON_BYTES = 16 * MIB
FACES = 4_000_000
"""As they are read; what is built has fewer."""
CORNERS = 4 * FACES
VERTICES = 6_000_000
NODES = 20_000
DEPTH = 200
"""Levels of parents and children."""
PARTS = 20_000
"""Meshes, materials, pictures, instances ... of one kind."""
MATERIALS = 256
PICTURES = 64
"""Of a glTF; further ones are left out."""
PICTURE_BYTES = 64 * MIB
PICTURE_PIXELS = 8192 * 8192
"""Of a picture as it comes; none is decoded before its header says so."""
PICTURE_SIDE = 2048
"""Pixels: larger pictures are made smaller."""
SECONDS = 60
"""Of reading, by the clock and of the processor."""
MEMORY = 6 << 30
"""Bytes of address space of the process that reads; Blender itself takes most of two."""
COORDINATE = 1e7
"""Largest coordinate, in the file's units."""
