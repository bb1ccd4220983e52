"""Phases, and conflicts on the clock: `app/bml/choice/timing`. Begin with `test_phases.py`."""
