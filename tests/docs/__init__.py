"""The pages of docs/ that have examples: each example is run as it stands there. Imports what the page is about. Begin
with `test_authoring_page.py`, which follows an author through a copy of the checkout.
"""
