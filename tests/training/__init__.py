"""The parts of `training/` that have laws of their own; what is trained is measured by `benchmarks/`. Begin with
`agitation/test_choosing.py`.
"""
