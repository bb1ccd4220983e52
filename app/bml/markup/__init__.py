"""BML documents: the data model, the schema of elements and attributes, reading and writing XML and attribute values,
and validation by the rules of strict realizers. Independent of performances except for word times. Imports only the
data model. Begin with `documents.py` and `elements.py`."""
