"""What each command does: a function of the arguments and the log that returns the exit code. A command has a module of
its own, with a function `run`, or shares one (`understudy.cli.main.SHARED`); only that of the command called is
imported. Commands import what they share (`inputs`, `outputs`, `files`, `log`) and, beneath `cli`, the library, the
authoring room and the schemas. Begin with `hearing.py`, then `perform.py`.
"""
