"""Idle behaviour of eyes, lids, chest and weight: when it happens, drawn at random by seed. Imports the table's
directions. Begin with `idle_behaviors.py`."""
