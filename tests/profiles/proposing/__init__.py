"""A first annotation of a motion."""
