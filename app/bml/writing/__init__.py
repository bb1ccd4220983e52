"""The kept behaviours of a performance as a document: BML 1.0 core (`blocks`) or SmartBody's dialect (`smartbody`), as
XML or JSON. Imports `markup`, and from `choice` the tables of face lexemes and visemes. Begin with `writer.py`."""
