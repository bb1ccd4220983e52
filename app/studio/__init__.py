"""The studio: a page at `/` of the service on which lines are performed, inspected, edited and exported.

`pages.py` serves it; `page/` is all that a browser gets of it. It asks the service as every client does.
"""
