"""Plans of gestures: `app/realizer/scheduling` on clips made by hand (`support.gesture_clips`). Begin with
`test_planning.py`.
"""
