"""What the service tells of itself: the OpenAPI document that clients are generated from, and the page that shows it.
Imports `schemas`. Begin with `document.py`.
"""
