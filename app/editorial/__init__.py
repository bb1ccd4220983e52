"""A performance for those who cut, annotate and count: timelines, tiers and tables of its functions and movements, as
they were realized. Begin with `events.py`."""
