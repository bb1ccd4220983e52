"""Trains the agitation model of `models/agitation/` (paper §3.1.4)."""
