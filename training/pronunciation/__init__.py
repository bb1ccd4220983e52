"""Makes `models/pronunciation/` from the dictionary that ships with pocketsphinx."""
