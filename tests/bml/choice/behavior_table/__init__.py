"""The table of behaviors and its lexemes: `app/bml/choice/behavior_table`. Begin with `test_table.py`."""
