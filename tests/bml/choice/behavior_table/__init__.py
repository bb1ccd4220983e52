"""The table of behaviors and its words: `app/bml/choice/behavior_table`. Begin with `test_table.py`."""
