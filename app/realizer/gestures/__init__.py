"""The gesture language and library (Gesture Engine §4): files read into definitions, checked, and made into clips at
each level of agitation, and the values of a plan of gestures. Imports `geometry` and `body`. Begin with `gesture.py`,
what a gesture is, and `library.py`, which loads them all; docs/gesture-language.md shows how they are written.
"""
