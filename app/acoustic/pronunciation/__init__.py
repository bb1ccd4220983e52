"""Pronunciation of transcripts: text normalization of numbers, abbreviations and symbols (`normalisation`,
`spoken_numbers`), and the phones of each spoken word, from the dictionary, by rule (`pronouncer`), or predicted from
the spelling (`graphones`). Imports only the ground floor. Begin with `pronouncer.py`."""
