"""The output of commands: the picture of an analysis."""
