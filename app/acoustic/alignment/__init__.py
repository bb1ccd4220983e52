"""Forced alignment: the decoder (pocketsphinx, in a separate process), handling of long audio and of transcripts that
do not fit, refinement of boundaries, and word timings of other tools. Imports `signal` and `pronunciation`. Begin with
`aligner.py`, then `decoder_process.py`, the client of the decoder, and `boundaries.py`, the refinement."""
