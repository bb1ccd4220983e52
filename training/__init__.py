"""Scripts that make what lies in models/, from data outside the repository, a folder for each model; `prominence.py`
and `voicing.py` fit weights that stand in the code itself. They import the package, whose own features they train on;
nothing in the package imports them. Begin with `agitation/__main__.py`.
"""
