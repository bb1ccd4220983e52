"""JSON input and output: `app/schemas`, every wrong field named. Begin with `test_requests.py`."""
