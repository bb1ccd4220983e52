"""Generates a gesture script from a profile and timed words, in the sixteen steps of NGS §3.3 (listed in
`generating.py`)."""
