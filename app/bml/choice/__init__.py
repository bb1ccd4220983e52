"""From behavior candidates to the schedule: which alternative shows each function, what gives way to what on a channel,
when phases fall, what eyes and head do by themselves, what listeners do, and which mouth shapes go with the speech. The
table of behaviors and the characters are read here (lexicon/behaviors.yaml, lexicon/characters). Imports only the
ground floor. Begin with `scheduling.py`, the stage in order, then `selection/choosing.py`.
"""
