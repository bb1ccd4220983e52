"""Performances as BML and JSON: `app/bml/writing`, held against the independent checker of `support`. Begin with
`test_writer.py`.
"""
