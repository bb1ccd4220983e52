"""The HTTP service: requests in, BML, JSON or motion out. `schemas` validates requests and `library` does the work;
here are routes, forms, content negotiation, limits, problem documents, metrics and reloading. Begin with
`application.py`, then `routes.py`.
"""
