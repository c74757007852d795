"""What people do, and what changes by it: motions, states, entrances and exits."""
