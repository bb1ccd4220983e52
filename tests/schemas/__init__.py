"""What comes in and goes out as JSON: `app/schemas`, every wrong field named. Begin with `test_requests.py`."""
