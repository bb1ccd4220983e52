"""Gaze, head movements and fixations: `app/realizer/head_and_gaze` on schedules made by hand. Begin with
`test_gaze.py`.
"""
