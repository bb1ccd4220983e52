"""Makes models/alignment from the half of TIMIT that `benchmarks.acoustic.alignment` does not report on: `python -m
training.alignment`. Imports the views of boundaries from `understudy.acoustic.alignment`. Begin with `__main__.py`.
"""
