"""Reads scripts in many file formats. Each module knows one; `reading` chooses by file name."""
