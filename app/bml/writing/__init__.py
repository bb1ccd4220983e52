"""The kept behaviors of a performance as a document: BML 1.0 core (`blocks`) or SmartBody's dialect (`smartbody`), as
XML or JSON. Imports `markup`, and from `choice` the words that faces and mouths go by. Begin with `writer.py`.
"""
