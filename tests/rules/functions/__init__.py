"""The shipped rules of `app/rules/functions`, class by class, on sentences: what must be found, and what looks like it
and must not. Imports `support` to derive functions. Begin with `test_function_rules.py`.
"""
