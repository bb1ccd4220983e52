"""Trains the choice of gestures, head movements and faces on directed lines and deliveries (models/acting).

`directed.py` reads the lines: those of ../shared/directing, and those of our own in `lines/`. `listening.py` says what
is heard of a delivery, `recordings.py` measures it. `encoder.py` fine-tunes the reader with PyTorch (`network.py`),
`exporting.py` writes it as ONNX (`graph.py`), `weights.py` fits what the named terms add to it, `biases.py` sets how
readily each family is chosen, `thresholds.py` when heads and faces are made.
"""
