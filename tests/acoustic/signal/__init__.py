"""Decoding, frames, spectra and the small numerical tools of `app/acoustic/signal`, mostly on signals made by formula
and held against definitions or librosa. Begin with `test_decoding.py`.
"""
