"""The fundamental frequency and which frames are voiced (paper §3.1.3), by summation of residual harmonics: the source
of the voice (`residual`), how much its spectrum speaks for each f0 (`harmonics`), and when frames count as voiced
(`periodicity`, `voicing`). Imports `signal`. Begin with `pitch.py`, which joins them.
"""
