"""Batches, room by room as in `app/batch`. Imports `understudy.batch`; the models of the session perform the lines of
`test_whole_run.py`, with which to begin."""
