"""What people do, and what changes by it: motions, postures, things in hand, entrances and exits."""
