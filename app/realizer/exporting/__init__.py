"""A motion as files of other tools: pure functions to bytes, one module a format (docs/motion-formats.md)."""
