"""English as screenplays write it: words, their forms, phrases and clauses."""
