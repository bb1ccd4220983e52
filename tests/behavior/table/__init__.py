"""The table of behaviors and its lexemes: `app/behavior/table`. Begin with `test_behavior_table.py`."""
