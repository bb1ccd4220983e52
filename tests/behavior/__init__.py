"""From functions to the schedule: `app/behavior` on utterances and candidates made by hand. Begin with
`choice/test_scheduling.py`.
"""
