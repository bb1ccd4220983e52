"""Pydantic models of all JSON that enters or leaves through the command line or the HTTP API, with conversions from and
to the data model. Imports `performance`, and for authored resources `authoring` and the data model of gestures. Begin
with `requests.py` and `responses.py`."""
