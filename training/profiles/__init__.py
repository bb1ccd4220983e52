"""The example annotations of examples/speakers/, made from our own performances."""
