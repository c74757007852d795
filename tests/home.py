"""Three short scenes in two places, made without Blender."""

from __future__ import annotations

from storyblender.settings import Settings

SETTINGS = Settings(width=160, look="fast", animatic=False, jobs=1)
SCRIPT = """INT. LIVING ROOM - DAY

ANNA sits on the sofa. TOM stands by the window. A letter lies on the table.

ANNA
You said you would write.

EXT. PARK - DAY

TOM sits on a bench.

INT. LIVING ROOM - NIGHT

ANNA sits alone on the sofa.
"""
