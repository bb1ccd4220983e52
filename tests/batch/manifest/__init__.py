"""The manifest, its rows and hashes."""
