"""Reads the input of commands: lines with their words and notes, recordings, corpora; and checks it before anything
large is loaded. Imports `files` and `log`, and beneath `cli` the stages' readers and `schemas`."""
