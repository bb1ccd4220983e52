"""Scripts that measure Understudy, in rooms named after the stages; each prints its figures, and docs/measurements
has them with the command: `python -m benchmarks.ROOM.NAME`. They import the package, readers of corpora from `training`
and the BML checker of `tests.support`; data outside the repository is given by its folder. Begin with `pipeline.py`:
the time of every stage."""
