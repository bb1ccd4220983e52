"""How well and how fast we hear: alignment, pitch, prominence, agitation, fillers, long and degraded audio, against
hand labels. Run `python -m benchmarks.acoustic.NAME`. Imports `understudy.acoustic`, and readers of corpora from
`training`. Begin with `alignment.py`.
"""
