"""Whether schedules are valid and fit what is said, and the cost of writing and reading BML. Run `python -m
benchmarks.bml.NAME`. Imports `understudy.bml`, the stages before it, and `performance`. Begin with `schedule.py`."""
