"""Recordings and their words in time, short enough for every test, and `make_fixtures.py`, which made them; the README
says where they come from. That script alone imports anything of the package, a type.
"""
