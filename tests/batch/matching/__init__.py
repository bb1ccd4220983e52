"""Lines and recordings, joined; the recordings are empty files with names."""
