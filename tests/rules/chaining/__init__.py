"""Running programs: `app/rules/chaining` on programs of a few rules, and compared with CLIPS, another forward chainer.
Begin with `test_chainer.py`."""
