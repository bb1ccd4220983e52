"""Annotations as people make them."""
