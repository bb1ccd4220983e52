"""The bytes of a recording as one signal, and what is measured of any signal, speech or not: frames, energy, Mel bands
and MFCC, loudness, the noise behind the speech; with the small numerical tools that other rooms share (peaks, best
paths, matrix products). Imports the values and errors alone, no other room. Begin with `decoding.py`, where audio comes
in, and `spectrum.py`.
"""
