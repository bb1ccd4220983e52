"""Matches lines with recordings. Imports the values of a batch and errors. Begin with `joining`."""
