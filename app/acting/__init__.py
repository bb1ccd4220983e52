"""Acting: which movements an audience reads as what.

A director thinks in families of gestures ("show the listener", "wipe it away"); `families` says which entries of the
behaviour table show each. Imports only the values, the errors and the YAML reader. Begin with `families.py`.
"""
