"""The gesture language and library: `app/realizer/gestures` on files written in the test, mistakes with their places,
and the gestures that ship. Imports `support` for files and clips. Begin with `test_language.py`.
"""
