"""The behaviours that could show each moment, notes and targets: `app/behavior/candidates`. Begin with
`test_planned.py`."""
