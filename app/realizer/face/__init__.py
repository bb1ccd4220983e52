"""The face: lips from visemes, expressions from FACS units and BML's lexemes, eyes and lids, all as weights of ARKit's
52 shapes, by the tables of lexicon/face.yaml. Imports `geometry` and `body`. Begin with `face.py`, which adds its parts
up.
"""
