"""The rule language: rule files parsed into syntax trees with positions, syntax mistakes explained to authors, and the
arithmetic of rules. Imports only the errors. Begin with `parsing.py` and the grammar in `grammar.lark`; `tree.py` has
the nodes of the tree."""
