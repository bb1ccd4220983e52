"""Where arms are: the poses that gestures say in words, inverse kinematics, rest poses, an arm's track of key poses in
time, and hands kept out of the body. Imports `geometry`, `body` and `gestures`. Begin with `posing.py` for one pose and
`arms.py` for an arm in time.
"""
