"""The HTTP door: requests in, BML, JSON or motion out. Thin: what a request means is in `schemas`, the work in
`performance` and `realization`; here are paths, forms, negotiation, limits, errors as problems, figures for operators,
and reloading. Imports those and `authoring`. Begin with `application.py`, which puts it together, then `routes.py`.
"""
