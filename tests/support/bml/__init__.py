"""Checkers of BML documents that tests use, and their own tests."""
