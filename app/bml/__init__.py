"""Chosen movements in; a timed schedule and its BML out (paper §3.5)."""
