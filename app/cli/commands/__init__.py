"""The commands: functions of the arguments and the log that return the exit code. A command has a module of its own,
with a function `run`, or shares one (`understudy.cli.main.SHARED`); only the module of the command called is imported.
Commands import `inputs`, `outputs`, `files`, `log` and, beneath `cli`, the library, `authoring` and `schemas`. Begin
with `hearing.py`, then `perform.py`.
"""
