"""Arms: symbolic poses converted to joint rotations by inverse kinematics, rest poses, tracks of key poses over time,
and collision avoidance. Imports `geometry`, `body` and `gestures`. Begin with `posing.py` for single poses and
`interpolation.py` for motion."""
