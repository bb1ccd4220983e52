"""`python -m understudy.cli`: the same as the installed command `understudy`."""

from .interruption import start

start()
