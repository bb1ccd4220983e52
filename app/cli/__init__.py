"""The command line: arguments and files in, results on standard output or in files, one line for every mistake.

`commands/` has one module per command, `arguments/` its arguments; `inputs/` and `outputs/` are shared by several
commands. Imports `performance`, `realization`, `authoring`, `schemas`, a few values of the stages to print them,
`batch`, and `api` to serve. Begin with `main.py`, then `commands/perform.py`.
"""
