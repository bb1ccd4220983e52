"""BML files, ours or others', as behaviors whose times are all known: parsed with every mistake at its place, sync
references resolved against the words and the constraints of the block. Imports `markup`, `choice` and `writing`, whose
tables it reads the other way round. Begin with `reader.py`, then `resolving.py`.
"""
