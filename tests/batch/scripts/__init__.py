"""Scripts of every kind, read from text written here."""
