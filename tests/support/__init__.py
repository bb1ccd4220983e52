"""What several tests share: utterances and motions made by hand, gesture files, an independent checker of BML, a reader
of glTF, the examples of docs/python.md. Nothing here stands in for a stage of ours. Imports the package, and for the
checker nothing of it. Begin with `utterances.py`.
"""
