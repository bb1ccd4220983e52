"""Applies motion to avatars of others: GLB and VRM files, read, checked, and given our motion."""
