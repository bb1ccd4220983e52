"""The processes that work, and the service's side of them: mirrors `app/api/workers`. Begin with `test_pool.py`."""
