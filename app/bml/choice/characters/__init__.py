"""Who moves: the characters (lexicon/characters), their entries of the table, and the forms their gestures take at a
level of agitation. Imports `behavior_table` and `idle`. Begin with `characters.py`.
"""
