"""The gesture language and library (Gesture Engine §4): definitions read from files, checked, and made into clips at
each level of agitation; and the data of gesture plans. Imports `geometry` and `body`. Begin with `gesture.py`, the data
model, and `library.py`, which loads all definitions; docs/gesture-language.md describes the language."""
