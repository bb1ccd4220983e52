"""`understudy say`: a line without a recording in, BML out; everything but the sound as in `perform`."""

from .perform import run

__all__ = ["run"]
