"""Lips, expressions, eyes and lids: `app/realizer/face` on visemes and behaviors made by hand (`support.speaking`).
Begin with `test_lips.py`.
"""
