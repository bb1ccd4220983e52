"""Gestures from the voice alone: prosody in, gesture phrases in time out. A stage; numpy only.

`counting`, `mixtures` and `clustering` learn a `semi_markov` model; `viterbi` finds the likeliest path through a whole
recording and `live_decoder` through one that still goes on; `unit_selection` picks recorded movements that show it.
Sources: "RTS" is the thesis Real-Time Speech Driven
Gesture Animation, "AHG" the paper Affect-Expressive Hand Gestures (docs/references.md). Conventions: a frame is
`semi_markov.FRAME_S` long, boundary b lies after b frames, scores are natural logarithms, minus infinity where
something cannot be.
"""
