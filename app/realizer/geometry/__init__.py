"""Mathematics of motion that knows of no body: rotations as quaternions, angles, splines, easing and noise, on whole
arrays at once. Imports the values alone. Begin with `rotations.py`.
"""
