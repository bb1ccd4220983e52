"""The gestures of the library are told apart from far away: the commonest ones all, the others as far as they were."""

import pytest

from benchmarks.realizer.gestures.commonest import commonest
from benchmarks.realizer.gestures.likeness import Likeness
from benchmarks.realizer.gestures.silhouettes import mixed_up, of_the_commonest, pairs_of, stroke_poses
from understudy.model import Level
from understudy.models import load_realizer
from understudy.realizer.gestures.library import Library

PAIRS, MIXED_UP, TWINS = 203, 149, 24
"""Pairs of different meaning that look alike at the stroke's end, of these those that somebody would mix up, and of
all those that look alike from the stroke's start on, at medium agitation: of 497 gestures on 28 November 2026. They
may become fewer."""


@pytest.fixture(scope="module")
def library() -> Library:
    return load_realizer().library


@pytest.fixture(scope="module", params=list(Level))
def pairs(library: Library, request: pytest.FixtureRequest) -> tuple[Level, list[Likeness]]:
    return request.param, pairs_of(library, stroke_poses(library, request.param))


def test_the_commonest_gestures_are_told_apart_at_every_level(pairs: tuple[Level, list[Likeness]]) -> None:
    level, found = pairs
    alike = [f"{each.one}, {each.other}" for each in found if of_the_commonest(each)]
    assert not alike, f"{level}: {'; '.join(alike)}; python -m benchmarks.realizer.gestures.silhouettes --level {level}"


def test_no_common_gesture_is_mixed_up_with_any_other_from_the_start_on(
    library: Library, pairs: tuple[Level, list[Likeness]]
) -> None:
    level, found = pairs
    common = commonest().keys()
    twins = [each for each in found if each.twins and mixed_up(library, each)]
    assert not [f"{level}: {each.one}, {each.other}" for each in twins if {each.one, each.other} & common]


def test_gestures_of_different_meaning_are_told_apart_as_far_as_they_were(
    library: Library, pairs: tuple[Level, list[Likeness]]
) -> None:
    level, found = pairs
    if level is not Level.MEDIUM:
        return
    twins = sorted(f"{each.one}, {each.other}" for each in found if each.twins)
    assert len(twins) <= TWINS, f"{len(twins)} pairs look alike from the start on: {'; '.join(twins)}"
    assert len(found) <= PAIRS, f"{len(found)} pairs look alike; python -m benchmarks.realizer.gestures.silhouettes"
    assert sum(mixed_up(library, each) for each in found) <= MIXED_UP


def test_the_commonest_are_in_the_library(library: Library) -> None:
    assert len(commonest()) == 60
    assert commonest().keys() <= {each.name for each in library.definitions}
