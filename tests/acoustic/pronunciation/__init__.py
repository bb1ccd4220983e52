"""Text normalization and pronunciation: `app/acoustic/pronunciation`, by tables of cases. Begin with
`test_pronouncer.py`."""
