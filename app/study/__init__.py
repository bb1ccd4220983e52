"""The papers' user studies on one's own lines: clips and a blind page (`understudy study make`), and the statistics of
the answers (`understudy study score`).

Two comparisons are known (`understudy.study.comparison`): the modes of the main paper (§5), and units against single
gestures (NGS §4.1). docs/studies.md says how to run one.
"""
