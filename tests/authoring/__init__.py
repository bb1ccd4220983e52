"""What authors edit, as their tools see it: `app/authoring` on the shipped files and on copies with mistakes. Begin
with `test_catalogue.py`.
"""
