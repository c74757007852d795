"""Where people and things are in relation to each other."""
