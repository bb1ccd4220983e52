"""What holds whichever way a line comes in: command line and service give the same bytes, forms and messages. Imports
the doors, `performance` and `support`. Begin with `test_lines.py`.
"""
