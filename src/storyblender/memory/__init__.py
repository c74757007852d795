"""The Continuity Memory Graph (paper, section 3.2): frozen data, no I/O, no engine."""
