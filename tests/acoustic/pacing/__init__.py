"""Words without a recording: `app/acoustic/pacing` on hand-made words. Begin with `test_word_times.py`."""
