"""Motion, room by room as in `app/realizer`; here the gesture library and whole lines realized. Imports
`understudy.realizer`, and `performance` for the lines. Begin with `test_realizing.py`: what must hold of every motion.
"""
