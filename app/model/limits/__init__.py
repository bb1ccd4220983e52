"""Limits that several stages share: what arms can do in time, and how large a motion may be."""
