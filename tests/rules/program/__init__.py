"""Rule files as programs: what is checked, how rules are ordered and planned (`app/rules/program`). Begin with
`test_checking.py`.
"""
