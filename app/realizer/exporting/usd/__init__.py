"""USD: the animated mannequin for Pixar's scene description, by usd-core (the extra `usd`). Begin with `stage.py`."""
