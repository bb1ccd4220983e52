"""Agitation and the features that it is judged by, on voices made by formula: `app/acoustic/agitation`. Begin with
`test_agitation.py`.
"""
