"""Gestures from the voice alone: prosody in, timed gesture phrases out. A stage; depends on numpy only.

`estimation` trains a `semi_markov` model; `trellis` finds the most likely path through a complete recording,
`live_decoder` through a live stream.
Sources: "RTS" is the thesis Real-Time Speech Driven Gesture Animation, "AHG" the paper Affect-Expressive Hand Gestures
(docs/references.md). Conventions: a frame is `semi_markov.FRAME_S` long, boundary b lies after b frames, scores are
natural logarithms, minus infinity for impossible events.
"""
