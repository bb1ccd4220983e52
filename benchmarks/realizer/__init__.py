"""Whether motion is such as people make. Here are the measures of the whole, in the rooms those of its parts, named as
in `understudy.realizer`. Run `python -m benchmarks.realizer.NAME` or `….ROOM.NAME`. Imports `understudy.realizer`,
`performance` and `realization`. Begin with `motion.py`, which has the realizer's bars.
"""
