"""One module a command, with a function `run(arguments, log)` that returns the exit code; `understudy.cli.main` imports
only the one that is called. Imports what commands share (`inputs`, `outputs`, `files`, `log`) and, beneath `cli`,
`performance`, `realization`, `authoring` and `schemas`; `serve` imports `api`, and `gestures` the rooms of `realizer`
that draw. Begin with `align.py`, one of the shortest, then `perform.py`."""
