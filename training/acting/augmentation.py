"""Varies directed lines for training: cut at the end of a sentence, joined, with some of their pieces hidden.

A reader that sees lines whole and alone learns to depend on that. The targets go with their words.
"""

import random
from dataclasses import replace
from itertools import pairwise

import numpy as np

from .encoder import Encoded

FEWEST_WORDS, HIDDEN = 3, 0.03
"""A part of fewer words is no line; the share of pieces that is hidden."""


def cut(each: Encoded, chance: random.Random) -> Encoded:
    """What comes before or after the end of a sentence; the whole line where it has none inside."""
    words = each.line.words
    ends = [place + 1 for place, (word, _) in enumerate(pairwise(words)) if word.rstrip("'\"”’)")[-1:] in set(".!?…")]
    if not ends:
        return each
    end = chance.choice(ends)
    return _part(each, 0, end) if chance.random() < 0.5 else _part(each, end, len(words))


def _part(each: Encoded, first: int, last: int) -> Encoded:
    if last - first < FEWEST_WORDS:
        return each
    ends = each.ends[first:last]
    return replace(
        each,
        line=replace(each.line, words=each.line.words[first:last]),
        pieces=[each.pieces[0], *each.pieces[ends[0, 0] : ends[-1, 1] + 1], each.pieces[-1]],
        ends=ends - (ends[0, 0] - 1),
        wanted=each.wanted[first:last],
        counts=each.counts[first:last],
    )


def joined(first: Encoded, second: Encoded) -> Encoded:
    """Two lines as one, under the name of the first."""
    return replace(
        first,
        line=replace(first.line, words=first.line.words + second.line.words),
        pieces=[*first.pieces[:-1], *second.pieces[1:]],
        ends=np.concatenate([first.ends, second.ends + len(first.pieces) - 2]),
        wanted=np.concatenate([first.wanted, second.wanted]),
        counts=np.concatenate([first.counts, second.counts]),
    )


def with_hidden(each: Encoded, mask: int, chance: random.Random) -> Encoded:
    """The line with some of its pieces, drawn by chance, replaced by the piece `mask`."""
    inner = [mask if chance.random() < HIDDEN else piece for piece in each.pieces[1:-1]]
    return replace(each, pieces=[each.pieces[0], *inner, each.pieces[-1]])
