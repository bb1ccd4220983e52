"""Agitation and the features that it is judged by, mostly on signals made by formula: `app/acoustic/agitation`. Begin
with `test_agitation.py`.
"""
