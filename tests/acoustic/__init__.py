"""Hearing, room by room as in `app/acoustic`. Signals made by formula wherever the right answer can be known,
recordings of `tests/audio` else. Imports `understudy.acoustic` and the values. Begin with `signal/test_decoding.py`.
"""
