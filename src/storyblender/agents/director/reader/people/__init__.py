"""People of a script and the words that mean them: names, nouns, pronouns."""
