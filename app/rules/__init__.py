"""The rule language and its forward chainer; functions derived and behaviours chosen by rule (paper §3.3, §3.4)."""
