"""Sync points that are relative to each other, missing, or before the beginning."""

import pytest

from understudy.bml.markup.documents import Reference, Time
from understudy.bml.reading.phase_completion import StatedPoints, complete, resolve_times

NAMES = ("start", "stroke", "end")


def wanted(name: str, **times: Time) -> StatedPoints:
    return StatedPoints(name, NAMES, (0.4, 0.6), times)


@pytest.mark.parametrize(
    ("told", "expected"),
    [
        ({}, (0.0, 0.4, 1.0)),
        ({"start": 2.0}, (2.0, 2.4, 3.0)),
        ({"stroke": 2.0}, (1.6, 2.0, 2.6)),
        ({"stroke": 0.1}, (0.0, 0.1, 0.7)),
        ({"start": 0.0, "end": 2.0}, (0.0, 0.8, 2.0)),
        ({"start": 1.0, "end": 0.5}, (1.0, 1.0, 1.0)),
    ],
    ids=["nothing", "start", "stroke", "no room before it", "both ends", "end before start"],
)
def test_what_is_not_told_lies_at_usual_distances(told: dict[str, float], expected: tuple[float, ...]) -> None:
    assert tuple(complete(wanted("a"), told).values()) == pytest.approx(expected)


def test_references_are_followed_in_whatever_order_they_stand() -> None:
    chain = [
        wanted("c", start=Reference("b", "end")),
        wanted("b", stroke=Reference("a", "stroke", 1.0)),
        wanted("a", start=0.5),
    ]
    points, lost = resolve_times(chain, {})
    assert lost == ()
    assert points["a"]["stroke"] == pytest.approx(0.9)
    assert points["b"] == pytest.approx({"start": 1.5, "stroke": 1.9, "end": 2.5})
    assert points["c"]["start"] == pytest.approx(2.5)


def test_a_circle_and_what_hangs_on_it_have_no_time() -> None:
    circle = [
        wanted("a", start=Reference("b", "end")),
        wanted("b", start=Reference("a", "end")),
        wanted("c", start=Reference("a", "start")),
        wanted("d", start=Reference("gone", "start")),
        wanted("e"),
    ]
    points, lost = resolve_times(circle, {})
    assert list(points) == ["e"]
    assert lost == ("a", "b", "c", "d")


def test_a_block_of_references_that_begins_too_early_comes_later_as_a_whole() -> None:
    early = [wanted("a"), wanted("b", start=Reference("a", "start", -2.0), end=Reference("a", "start"))]
    points, _lost = resolve_times(early, {})
    assert (points["a"]["start"], points["b"]["start"], points["b"]["end"]) == (2.0, 0.0, 2.0)


def test_beside_an_absolute_time_what_is_too_early_begins_at_0() -> None:
    early = [wanted("a", start=1.0), wanted("b", start=Reference("a", "start", -2.0))]
    points, _lost = resolve_times(early, {})
    assert (points["a"]["start"], points["b"]["start"]) == (1.0, 0.0)
