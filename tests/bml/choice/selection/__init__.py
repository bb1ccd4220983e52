"""Which alternative is taken, and what fills the rest: `app/bml/choice/selection`. Begin with `test_choosing.py`."""
