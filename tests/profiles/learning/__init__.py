"""From annotation to profile."""
