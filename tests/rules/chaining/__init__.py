"""Programs at work: `app/rules/chaining` on programs of a few rules, and held against CLIPS, another forward chainer.
Begin with `test_chainer.py`.
"""
