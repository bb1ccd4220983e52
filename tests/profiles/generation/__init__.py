"""From profile and words to a gesture script."""
