"""Words and phones in time: `app/acoustic/alignment` on the recordings of `tests/audio`, the decoder's process when it
dies, and timings made elsewhere. Begin with `test_aligner.py`.
"""
