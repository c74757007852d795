"""Pure geometry: boxes, relations, support, orbit, framing, continuity. numpy only."""
