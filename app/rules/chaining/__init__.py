"""Runs a program: converts an utterance to facts, derives all that follows by forward chaining (paper §3.3), and traces
which rules fired or nearly did. Imports `program`, `language` and `knowledge`. Begin with `chainer.py`, then
`facts.py`; `matching.py` and `tracing.py` are for authors only."""
