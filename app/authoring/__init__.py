"""Tools for authors of rules, words, characters and gestures: catalogue, proofreading, tracing on a text, watching
files. Imports the stages and `performance`; imported by `schemas`, the command line and the HTTP API. Begin with
`catalogue.py`, then `proofreading.py`, which implements `understudy rules check`."""
