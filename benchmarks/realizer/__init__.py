"""Whether motion is such as people make: gestures, head, lips, files, and the measures of wrists that they share. Run
`python -m benchmarks.realizer.NAME`. Imports `understudy.realizer`, `performance` and `realization`. Begin with
`motion.py`, which has the realizer's bars.
"""
