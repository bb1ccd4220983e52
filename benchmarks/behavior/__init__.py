"""Measures the choice of movements against directors' readings of the same lines.

Imports `understudy`, `training.acting`, which reads directed lines, and score.py of ../shared/directing. Begin with
`directing.py`.
"""
