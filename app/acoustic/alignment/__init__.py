"""Words and phones in time: the decoder (pocketsphinx, in a process of its own), what is done with long audio and with
words that do not fit, boundaries moved to where the spectrum changes, and timings made elsewhere, read and written.
Imports `signal` and `pronunciation`. Begin with `alignment.py`, then `decoder_process.py` for our end of the other
process and `boundaries.py` for what follows it.
"""
