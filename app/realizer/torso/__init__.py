"""Trunk, hips and legs: idle motion, breathing, postures and weight shifts, balance, and the trunk's part in gestures.
Imports `geometry`, `body`, and from `gestures` and `arms` the joints and rest poses. Begin with `idle.py`."""
