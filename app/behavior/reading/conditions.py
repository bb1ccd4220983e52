"""Which gestures can be shown on which words: some need a word nearby that says what to show ("drink", "tall"), some
suit only some levels of agitation (`lexicon/acting/families.yaml`).

A plan that weighed what cannot be made there would take strokes for it, and show something else. Near is within `NEAR`
words. Shapes: W words, L gesture lexemes, F gesture families.
"""

from collections import defaultdict
from collections.abc import Iterable, Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from ...model import Level, Moment, SingleArray, Utterance
from .families import FamilyBehavior
from .player import Player
from .strokes import NEAR, Window

NO_WINDOWS: Mapping[int, Window] = MappingProxyType({})


def lemmas_about(utterance: Utterance, moment: Moment) -> frozenset[str]:
    """The lemmas of a moment's words and of those near its stroke, in lower case."""
    first, last = min(moment.first, moment.stroke - NEAR), max(moment.last, moment.stroke + NEAR)
    return frozenset(token.lemma.lower() for token in utterance.parse.tokens if first <= token.word <= last)


def possible_families(
    needed: Mapping[str, frozenset[str]], families: tuple[str, ...], utterance: Utterance
) -> SingleArray:
    """Which families can be shown on each word (W, F), 0 or 1; `needed` are the lemmas of those that need one."""
    possible = np.ones((len(utterance.words), len(families)), np.float32)
    words = _words_of_lemmas(utterance)
    for family, lemmas in needed.items():
        if family in families:
            possible[:, families.index(family)] = _near_any(lemmas, words, len(possible))
    return possible


def possible_lexemes(
    lexemes: Mapping[str, int], player: Player, utterance: Utterance, windows: Mapping[int, Window] = NO_WINDOWS
) -> NDArray[np.bool_]:
    """Which lexemes some behaviour of the player's families can show on each word (W, L). Strokes that are taken have
    `windows`: of two next to a number, only one can count it."""
    possible = np.zeros((len(utterance.words), len(lexemes)), np.bool_)
    words = _words_of_lemmas(utterance)
    for lexeme, behavior in _listed(player, utterance.level):
        if lexeme in lexemes:
            shown = _near_any(behavior.lemmas, words, len(possible), windows) if behavior.lemmas else True
            possible[:, lexemes[lexeme]] |= shown
    return possible


def _words_of_lemmas(utterance: Utterance) -> Mapping[str, tuple[int, ...]]:
    """The words of each lemma, in lower case."""
    words: dict[str, list[int]] = defaultdict(list)
    for token in utterance.parse.tokens:
        words[token.lemma.lower()].append(token.word)
    return {lemma: tuple(places) for lemma, places in words.items()}


def _listed(player: Player, level: Level) -> Iterable[tuple[str, FamilyBehavior]]:
    """The player's gestures for a level of agitation, with their lexemes."""
    listed = (behavior for family in player.families.gesture.values() for behavior in family)
    return (
        (player.lexeme(each.name), each) for each in listed if each.name in player.behaviors and level in each.levels
    )


def _near_any(
    lemmas: frozenset[str],
    words: Mapping[str, tuple[int, ...]],
    count: int,
    windows: Mapping[int, Window] = NO_WINDOWS,
) -> NDArray[np.bool_]:
    """Which of `count` words are near one of the lemmas, or have one in their window."""
    near = np.zeros(count, np.bool_)
    places = [word for lemma in lemmas & words.keys() for word in words[lemma]]
    for word in places:
        near[max(0, word - NEAR) : word + NEAR + 1] = True
    for stroke, (left, right) in windows.items():
        near[stroke] = any(stroke - left <= word <= stroke + right for word in places)
    return near
