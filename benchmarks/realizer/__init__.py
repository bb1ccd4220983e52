"""Whether motion resembles people's. The measures of the whole realizer are here, those of its parts in rooms named as
in `understudy.realizer`. Run `python -m benchmarks.realizer.NAME` or `….ROOM.NAME`. Imports `understudy.realizer`,
`performance` and `realization`. Begin with `motion.py`, which has the realizer's bars."""
