"""The listeners: their places, which of them a movement addresses, and their own behaviors. Imports `scheduling` and
what it imports. Begin with `listening.py`."""
