"""What commands read: lines with their words and notes, recordings, corpora, and what of it is wrong before anything
large is loaded. Imports `files` and `log`, and beneath `cli` the stages' readers and `schemas`.
"""
