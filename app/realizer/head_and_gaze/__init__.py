"""Where the head goes and the eyes look: gaze with eyes, head and trunk, nods and shakes, fixations, and what pointing
hands point at. Imports `geometry`, `body`, the values of `gestures`, and of `torso` how lively a body is. Begin with
`gaze.py` and `head.py`, two of the paper's controllers.
"""
