"""The commands: `app/cli` called as a function, the outputs of each, exit codes and one line for every mistake. Begin
with `test_cli.py`."""
