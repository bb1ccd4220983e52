"""Inputs, files and live messages that are almost valid. Begin with `inputs.py`."""
