"""Decoding, frames, spectra and the small numerical tools of `app/acoustic/signal`, mostly on synthetic signals and
compared with definitions or librosa. Begin with `test_decoding.py`."""
