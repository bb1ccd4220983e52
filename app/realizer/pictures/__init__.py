"""Motion as pictures, to judge it by eye: a contact sheet of the mannequin and the speeds of the wrists. Imports
`geometry`, `body` and `mannequin`; matplotlib only when a picture is drawn. Begin with `contact_sheet.py`.
"""
