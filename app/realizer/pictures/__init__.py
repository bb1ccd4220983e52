"""Pictures for judging motion by eye: contact sheets of the mannequin and plots of wrist speeds. Imports `geometry`,
`body` and `mannequin`, and matplotlib only when a picture is drawn. Begin with `contact_sheet.py`."""
