"""Tests of the OpenAPI document, and of clients that are generated from it. Begin with `test_document.py`."""
