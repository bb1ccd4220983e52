"""From a profile and timed words to a gesture script, in the sixteen steps of NGS §3.3 (`generating.py` has them in
order)."""
