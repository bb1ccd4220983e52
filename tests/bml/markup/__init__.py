"""BML as values and as XML: `app/bml/markup`, what is written and read back, and what is refused. Begin with
`test_markup.py`.
"""
