"""What accompanies the speech itself: its lead-in, its stresses and phrases for the realizer, its visemes. Imports
`timing`. Begin with `visemes.py`."""
