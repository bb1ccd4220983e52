"""The pages of docs/ that have examples: each example is run as printed. Imports what the pages are about. Begin with
`test_authored_pages.py`, which follows an author through a copy of the checkout."""
