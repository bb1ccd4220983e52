"""BML as such: a document as a value, the one table of elements and attributes, XML and attribute values read and
written, and what strict realizers refuse. Knows nothing of performances but the times of words. Imports the values
alone. Begin with `documents.py` and `elements.py`.
"""
