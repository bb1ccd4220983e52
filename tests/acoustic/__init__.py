"""Tests of the acoustic stage, room by room as in `app/acoustic`. Signals are synthesized wherever the correct result
can be computed, otherwise recordings of `tests/audio` are used. Imports `understudy.acoustic` and the data model. Begin
with `signal/test_decoding.py`."""
