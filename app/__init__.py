"""Understudy performs a spoken line in an actor's stead: audio and words in, a schedule of movements out."""

__version__ = "0.1.0"
