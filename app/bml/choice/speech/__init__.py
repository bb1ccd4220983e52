"""What goes with the speech itself: its lead-in, its stresses and phrases as the realizer needs them, its mouth shapes.
Imports `timing`. Begin with `visemes.py`.
"""
