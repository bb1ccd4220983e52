"""The choice of movements, and BML out and in, room by room as in `app/bml`. Begin with `choice/test_scheduling.py`."""
