"""Compiles syntax trees to a program: checks all rules together and each by itself, orders them so that negation is
safe (stratification), and compiles each rule into steps with planned joins. Imports `language` and `knowledge`. Begin
with `loading.py`, which calls these stages in order."""
