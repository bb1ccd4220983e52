"""Exports a performance for editing, annotation and statistics: timelines, tiers and tables of its functions and
behaviours, as they were realized. Begin with `events.py`."""
