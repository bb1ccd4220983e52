"""Behaviours in time: what a performance says of them, their strips, and BML with the strips' changes."""
