"""Set pieces: everything of a set that is neither wall nor slab. One builder a part, in the piece's own frame."""

from storyblender.blender.sets.pieces.registry import PIECES, PieceSpec, piece, piece_mesh

__all__ = ["PIECES", "PieceSpec", "piece", "piece_mesh"]
