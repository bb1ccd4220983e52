"""The tools of authors: `app/authoring` on the shipped files and on copies with mistakes. Begin with
`test_catalogue.py`."""
