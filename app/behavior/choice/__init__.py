"""Decides which alternative shows each function, in each of the three modes, and fills the remaining time. Imports
`characters` and `timing`. Begin with `choosing.py`."""
