"""Words in; parts of speech, lemmas, dependencies, phrases and clauses out (paper §3.2)."""
