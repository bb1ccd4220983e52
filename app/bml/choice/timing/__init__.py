"""When phases fall on the words, and what gives way where two behaviors meet on the clock. Imports `behavior_table` and
`idle`. Begin with `phases.py`, then `candidates.py`.
"""
