"""Whether schedules are sound and fit what is said, and what BML costs to write and read. Run `python -m
benchmarks.bml.NAME`. Imports `understudy.bml`, the stages before it, and `performance`. Begin with `schedule.py`.
"""
