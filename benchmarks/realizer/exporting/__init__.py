"""Files of motion: what other programs make of them, broken avatars, sparse keys."""
