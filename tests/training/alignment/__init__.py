"""How TIMIT is read and the boundary model trained and kept: `training/alignment`, on sentences made in the test. Begin
with `test_main.py`.
"""
