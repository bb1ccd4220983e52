"""Times of phases, and conflicts: `app/bml/choice/timing`. Begin with `test_phases.py`."""
