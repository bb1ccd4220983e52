"""The face: lip sync with coarticulation, expressions from FACS units and BML lexemes, eye looks and lids, as weights
of ARKit's 52 blendshapes, with the tables of lexicon/face.yaml. Imports `geometry` and `body`. Begin with
`blendshapes.py`, which combines the parts."""
