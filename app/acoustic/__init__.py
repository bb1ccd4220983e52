"""Audio in; words and phones in time, spectra, energy, pitch, stress and agitation out (paper §3.1). The rooms are
`signal`, `pitch`, `pronunciation`, `alignment`, `stress` and `agitation`, each importing only those named before it;
`contours.py` is the one pass that measures the signal frame by frame. Besides the values and errors of the ground
floor, nothing of the package is imported here but `yaml_files`. Begin with `contours.py`, then
`alignment/alignment.py`.
"""
