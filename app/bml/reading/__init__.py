"""BML files, ours or others', as behaviours with absolute times: parsed with the place of every mistake, with sync
references and constraints resolved. Imports `markup`, `choice` and `writing`, whose tables it inverts. Begin with
`reader.py`, then `resolving.py`."""
