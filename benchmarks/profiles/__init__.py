"""Whether gestures made by a profile resemble the speaker's. Run `python -m benchmarks.profiles`. Imports
`understudy.profiles`, and `training.profiles` for lines without recordings. Begin with `__main__.py`."""
