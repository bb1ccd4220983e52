"""What authors edit, for their tools: listed with its place, checked as a whole, traced on a text, watched for changes.
Imports the stages and `performance`, and is imported by `schemas` and the doors. Begin with `catalogue.py`, then
`proofreading.py`, which is behind `understudy rules check`.
"""
