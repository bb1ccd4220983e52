"""Acoustic analysis of a recording (paper §3.1): aligned words and phones, spectra, energy, pitch, stress, agitation
and affect. The rooms are `signal`, `pitch`, `pronunciation`, `alignment`, `stress`, `agitation` and `affect`, each
importing only those before it; `stage.py` runs them all. From the rest of the package only
the data model, the errors and `yaml_files` are imported. Begin with `stage.py`, then `alignment/aligner.py`."""
