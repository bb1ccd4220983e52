"""From candidates to the schedule: `app/bml/choice` on utterances and candidates made by hand. Begin with
`test_scheduling.py`.
"""
