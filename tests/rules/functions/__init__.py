"""The shipped rules of `app/rules/functions`, class by class, on sentences: what must be found, and similar sentences
in which it must not. Imports `support` to derive functions. Begin with `test_function_rules.py`."""
