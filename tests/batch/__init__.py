"""Whole scripts, room by room as in `app/batch`. Imports `understudy.batch`; one session's models perform the lines of
`test_batch.py`, with which to begin.
"""
