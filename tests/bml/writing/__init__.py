"""Performances as BML and JSON: `app/bml/writing`, checked by the independent checker of `support`. Begin with
`test_writer.py`."""
