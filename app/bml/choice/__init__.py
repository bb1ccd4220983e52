"""From behavior candidates to the schedule: which alternative shows each function, how conflicts on a channel are
resolved, the times of phases, idle movements of eyes and head, the listeners' behaviors, and the visemes. The table of
behaviors and the characters are read here (lexicon/behaviors.yaml, lexicon/characters). Imports only the ground floor.
Begin with `scheduling.py`, the stage in order, then `selection/choosing.py`."""
