"""Makes models/pronunciation from the dictionary that ships with pocketsphinx: letters aligned with phones, then a
model of sequences of such pairs. Run `python -m training.pronunciation.train`; begin with `train.py`. Imports the
model's form from `understudy.acoustic.pronunciation`.
"""
