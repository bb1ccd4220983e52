"""The JSON shapes of what comes in and goes out, the same through every door: checked with pydantic and turned into the
values of the performance, and back. Imports `performance`, `realization` and, for what authors edit, `authoring`. Begin
with `requests.py` and `responses.py`.
"""
