"""How words are said: a transcript's numbers, abbreviations and symbols written out (`normalisation`,
`spoken_numbers`), and the phones of each spoken word, from the dictionary, by rule, or guessed from its spelling
(`graphones`). Imports only the ground floor. Begin with `pronunciation.py`.
"""
