"""The command line: arguments and files in, results on standard output or in files, one line for every mistake.

One module a command in `commands/`, its arguments in `arguments/`; `inputs/` and `outputs/` have what several commands
read and write. Imports `performance`, `realization`, `authoring`, `schemas`, a few values of the stages to print them,
`batch`, and `api` to serve. Begin with `main.py`, then `commands/perform.py`.
"""
