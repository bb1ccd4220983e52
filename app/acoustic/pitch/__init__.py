"""Fundamental frequency and voicing (paper §3.1.3) by summation of residual harmonics: the prediction residual
(`residual`), the score of each f0 candidate (`harmonics`), and the voicing decision (`periodicity`, `voicing`). Imports
`signal`. Begin with `tracking.py`, which combines them."""
