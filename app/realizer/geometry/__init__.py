"""Mathematics of motion, independent of the body and vectorized: rotations as quaternions, angles, splines, easing and
noise. Imports only the data model. Begin with `rotations.py`."""
