"""Motion files: reading by other programs, broken avatars, sparse keys."""
