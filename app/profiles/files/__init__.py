"""Reads and writes profiles as YAML files."""
