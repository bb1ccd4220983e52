"""Rule files as text in, syntax trees with places out, with every syntax mistake in an author's words; and what rules
can compute. Imports the errors alone. Begin with `language.py`, beside it the grammar in `grammar.lark`; the nodes of
the tree are in `tree.py`.
"""
