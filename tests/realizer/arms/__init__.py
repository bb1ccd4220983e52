"""Poses, reach, rests, tracks and collisions of arms: `app/realizer/arms`. Imports `support` for clips. Begin with
`test_posing.py`.
"""
