"""The gesture scheduler of the paper's §3.8: selects clips, resolves conflicts, blends neighbours, places rests, and
applies the result to the body. Imports all rooms before it except `face`. Begin with `planning.py`, which makes the
plan, then `gesture_controller.py`, which applies it."""
