"""Words and phones in time: `app/acoustic/alignment` on the recordings of `tests/audio`, its other process when it dies
or hangs, and timings made elsewhere. Begin with `test_alignment.py`.
"""
