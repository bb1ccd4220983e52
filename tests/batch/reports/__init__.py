"""The reports of a batch."""
