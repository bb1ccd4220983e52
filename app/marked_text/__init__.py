"""Texts with marks of how they are to be spoken and what they mean: *words* that are emphasized, and the tags of SSML,
APML and our own. Begin with `reading.py`. Imports only the ground floor."""
