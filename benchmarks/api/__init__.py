"""The service measured from outside, under attack and under load. Begin with `under_attack.py`."""
