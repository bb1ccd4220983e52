"""Rotations, splines, easing and noise of `app/realizer/geometry`, by the laws that they must obey. Begin with
`test_rotations.py`.
"""
