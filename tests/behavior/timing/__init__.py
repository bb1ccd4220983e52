"""Times of phases, and conflicts: `app/behavior/timing`. Begin with `test_phases.py`."""
