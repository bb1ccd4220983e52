"""Which alternative is taken, and what fills the rest: `app/behavior/choice`. Begin with `test_choosing.py`."""
