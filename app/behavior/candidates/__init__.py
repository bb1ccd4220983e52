"""The behaviours that could show each moment of a line, and what a director's notes and named targets ask for (paper
§3.4). Imports `reading`. Begin with `planned.py`."""
