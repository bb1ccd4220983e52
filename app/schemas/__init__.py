"""The JSON shapes of what comes in and goes out, the same through every door: checked with pydantic and turned into the
values of the performance, and back. Imports `performance`, and for what authors edit `authoring` and the values of
gestures. Begin with `requests.py` and `responses.py`.
"""
