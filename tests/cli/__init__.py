"""The commands: `app/cli` called as a function, what each writes where, exit codes and one line for every mistake.
Begin with `test_cli.py`.
"""
