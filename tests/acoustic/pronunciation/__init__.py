"""Written words and how they are said: `app/acoustic/pronunciation` by tables of cases. Begin with
`test_pronunciation.py`.
"""
