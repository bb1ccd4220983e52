"""Rule files as text: `app/rules/language`, every mistake with its line, column and wording. Begin with
`test_parsing.py`.
"""
