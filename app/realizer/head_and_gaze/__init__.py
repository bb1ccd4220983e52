"""Where the head goes and the eyes look: gaze with eyes, head and trunk, nods and shakes, fixations, and what pointing
hands point at. Imports `geometry`, `body` and the values of `gestures`. Begin with `gaze.py` and `head.py`, two of the
paper's controllers.
"""
