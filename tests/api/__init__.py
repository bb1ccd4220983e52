"""The service: `app/api` through a client, its limits just under and just over, broken forms, files left open. Begin
with `test_routes.py`.
"""
