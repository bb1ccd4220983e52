"""Frames to programs that show avatars, by UDP: a protocol a file, and who sends them."""
