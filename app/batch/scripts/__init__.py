"""Reads scripts as they come. Each module knows one kind of file; `reading` chooses by the name."""
