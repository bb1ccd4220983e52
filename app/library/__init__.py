"""The one interface of the product: what the command line, the service and batches call, as a user's Python does.

`import understudy` re-exports the functions that take files and keywords; the doors, which have checked their input
already, call those beside them that take values (`perform_line`, `prepare_schedule`). `checks` says what is wrong with
a line before anything large is loaded. Each module imports what its functions need, so that a door loads no more.

Models are loaded once (`performing.load`) and shared by threads. Audio, BML and words timed elsewhere are given as the
name of a file or as its content; every `write_…` returns the content of a file. Times are seconds from the start of the
audio. A mistake of the caller's raises an `InputError` with a stable code (docs/errors.md), a file that cannot be
opened an OSError. docs/python.md has examples.
"""
