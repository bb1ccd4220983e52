"""Syntax trees in, a program out: checked as a whole and rule by rule, put into an order in which negation is safe
(stratification), each rule compiled into steps with its joins planned. Imports `language` and `knowledge`. Begin with
`program.py`, which names these stages in order.
"""
