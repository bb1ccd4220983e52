"""Scripts that make the files in models/, from data outside the repository, a folder for each model; `prominence.py`
and `voicing.py` fit weights that are in the code itself. They import the package, on whose features they train; nothing
in the package imports them. Begin with `agitation/__main__.py`."""
