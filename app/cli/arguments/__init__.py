"""The arguments of every command. `parser.py` names the commands in their order; `options.py` has the options that
several of them take, the other modules those of one kind of command. Imports `files`, and values of the
stages for their choices.
"""
