"""Which alternative shows each function, in each of the three modes, and what fills the time left over. Imports
`characters` and `timing`. Begin with `choosing.py`.
"""
