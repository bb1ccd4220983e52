"""Matching lines and recordings; the recordings are empty files with names."""
