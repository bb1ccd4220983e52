"""The choice of movements, and writing and reading BML, room by room as in `app/bml`. Begin with
`choice/test_scheduling.py`."""
