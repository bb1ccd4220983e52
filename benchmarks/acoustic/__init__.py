"""How well and how fast we hear: alignment, pitch, prominence, agitation, fillers, long and degraded audio, against
hand labels. Run `python -m benchmarks.acoustic.NAME`. Imports `understudy.acoustic`, `performance`, and from `training`
the corpora and how models are made of them. Begin with `alignment.py`.
"""
