"""The gesture library: loading it, and its clips compared with motion capture."""
