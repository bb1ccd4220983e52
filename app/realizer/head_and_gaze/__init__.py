"""Head and gaze: gaze shifts of eyes, head and trunk, head movements, fixational eye movements, and targets of pointing
gestures. Imports `geometry`, `body`, the data model of `gestures`, and the amount of idle movement from `torso`. Begin
with `gaze.py` and `head.py`, two of the paper's controllers."""
