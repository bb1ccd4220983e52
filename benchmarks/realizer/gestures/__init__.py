"""The gesture library: its reading, and its clips beside motion capture."""
