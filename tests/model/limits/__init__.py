"""Limits that several stages share."""
