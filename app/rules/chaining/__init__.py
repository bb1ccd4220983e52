"""A program at work: facts made of an utterance, forward chaining to all that follows from them (paper §3.3), and the
trace of which rules fired or nearly did. Imports `program`, `language` and `knowledge`. Begin with `chainer.py`, then
`facts.py`; `matching.py` and `tracing.py` serve authors alone.
"""
