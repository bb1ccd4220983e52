"""Accuracy and speed of the acoustic stage: alignment, pitch, prominence, agitation, fillers, long and degraded audio,
against hand labels. Run `python -m benchmarks.acoustic.NAME`. Imports `understudy.acoustic`, `performance`, and from
`training` the corpora and the training functions. Begin with `alignment.py`."""
