"""The service measured from outside, under attack and under load. Begin with `under_attack.py`, or with
`drill.py`, which does everything at once."""
