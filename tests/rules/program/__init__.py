"""Compiling rule files: checks, order and plans of rules (`app/rules/program`). Begin with `test_checking.py`."""
