"""The input of commands: mistakes are reported before anything large is loaded."""
