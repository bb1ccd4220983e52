"""Repeats the papers' user studies with one's own lines: makes clips and a blind page (`understudy study make`), and
computes the statistics of the answers (`understudy study score`).

The comparisons are listed in `understudy.study.comparison`; docs/studies.md describes how to run a study.
"""
