"""Signal processing independent of speech: decoding audio files, frames, energy, Mel bands and MFCC, loudness,
background noise; and small numerical tools for the other rooms (peaks, best paths, matrix products). Imports only the
data model and errors. Begin with `decoding.py` and `spectrum.py`."""
