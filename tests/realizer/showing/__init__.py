"""Heights, sizes, numbers and places that gestures show: `app/realizer/showing`, measured on the whole body. Begin with
`test_slot_clips.py`.
"""
