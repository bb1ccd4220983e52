"""What trunk, hips and legs do, asked or not: standing, breath, sway, shifts of weight, and the trunk's part in
gestures and postures. Imports `geometry`, `body`, and of `gestures` and `arms` the joints and the poses at rest. Begin
with `idle.py`, the body that does nothing.
"""
