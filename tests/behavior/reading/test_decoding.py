from dataclasses import replace

import numpy as np
import pytest

from understudy.behavior.reading.decoding import MOST_HELD, Span, held, spans_of, stretch_levels, stretches_of


@pytest.mark.parametrize(
    ("text", "stretches"),
    [
        ("Well, I never said that. Did you?", [(0, 4), (5, 6)]),
        ("No, not now, and not here, my friend!", [(0, 2), (3, 5), (6, 7)]),
        ("one two three four five six seven eight nine ten", [(0, 4), (5, 9)]),
        ("", []),
    ],
)
def test_stretches_lie_between_punctuation_neither_short_nor_long(text: str, stretches: list[tuple[int, int]]) -> None:
    assert stretches_of(text.split()) == stretches


THRESHOLDS = {
    "nod": 0.3,
    "shake": 0.3,
    "tilt": 0.3,
    "turn": 0.3,
    "smile": 0.3,
    "sad": 0.3,
    "brows_up": 0.3,
    "frown": 0.3,
}


def spans(kinds: tuple[str, ...], *rows: tuple[float, ...]) -> list[Span]:
    return list(spans_of(kinds, np.array(rows, np.float32), [(0, len(rows) - 1)], THRESHOLDS))


def test_contrary_movements_are_not_made_in_one_stretch() -> None:
    (only,) = spans(("nod", "shake"), (0.5, 0.9), (0.5, 0.9))
    assert (only.kind, only.first, only.last) == ("shake", 0, 1)


def test_two_head_movements_come_one_after_the_other() -> None:
    made = spans(("nod", "turn"), (0.4, 0.9), (0.4, 0.5), (0.5, 0.4), (0.9, 0.4))
    assert [(each.kind, each.first, each.last) for each in made] == [("turn", 0, 1), ("nod", 2, 3)]


def test_a_head_that_nods_and_tilts_does_both_at_once_with_the_stroke_of_the_nod() -> None:
    made = spans(("nod", "tilt"), (0.4, 0.9), (0.4, 0.5), (0.5, 0.4), (0.8, 0.4))
    assert [(each.kind, each.first, each.last, each.stroke) for each in made] == [("tilted_nod", 0, 3, 3)]
    assert made[0].likely == pytest.approx(0.9)


@pytest.mark.parametrize(
    ("asked", "nod", "tilt"),
    [
        ({(2, "nod")}, (0, 2), (3, 3)),
        ({(3, "tilt")}, (0, 1), (2, 3)),
        ({(0, "nod")}, (0, 1), (2, 3)),
    ],
)
def test_a_movement_that_a_rule_asked_for_has_its_word(
    asked: set[tuple[int, str]], nod: tuple[int, int], tilt: tuple[int, int]
) -> None:
    likely = np.array([(0.5, 0.4), (0.4, 0.5), (0.8, 0.5), (0.4, 0.9)], np.float32)
    one, other = spans_of(("nod", "tilt"), likely, [(0, 3)], THRESHOLDS, asked=asked)
    assert ((one.kind, one.first, one.last), (other.kind, other.first, other.last)) == (("nod", *nod), ("tilt", *tilt))


def test_a_mouth_and_brows_go_together() -> None:
    made = spans(("smile", "brows_up"), (0.9, 0.8), (0.9, 0.8))
    assert {(each.kind, each.first, each.last) for each in made} == {("smile", 0, 1), ("brows_up", 0, 1)}


@pytest.mark.parametrize("kinds", [("smile", "sad"), ("brows_up", "frown")])
def test_a_stretch_has_one_face_of_the_mouth_and_one_of_the_brows(kinds: tuple[str, str]) -> None:
    (made,) = spans(kinds, (0.9, 0.8), (0.8, 0.8))
    assert (made.kind, made.first, made.last) == (kinds[0], 0, 1)


def spans_of_two(kinds: tuple[str, ...], *levels: tuple[float, ...]) -> set[tuple[str, int, int]]:
    """What is made in two stretches of two words, as likely on both."""
    likely = np.repeat(np.array(levels, np.float32), 2, axis=0)
    return {(each.kind, each.first, each.last) for each in spans_of(kinds, likely, [(0, 1), (2, 3)], THRESHOLDS)}


@pytest.mark.parametrize("levels", [((0.9,), (0.15,)), ((0.15,), (0.9,))])
def test_an_attitude_lasts_where_it_is_still_likely_and_other_faces_do_not(
    levels: tuple[tuple[float, ...], ...],
) -> None:
    assert spans_of_two(("smile",), *levels) == {("smile", 0, 1), ("smile", 2, 3)}
    assert len(spans_of_two(("brows_up",), *levels)) == 1


def test_the_likelier_of_two_is_made_and_not_the_one_further_above_its_threshold() -> None:
    likely = np.array([(0.6, 0.8)], np.float32)
    (made,) = spans_of(("brows_up", "frown"), likely, [(0, 0)], {"brows_up": 0.1, "frown": 0.7})
    assert made.kind == "frown"


def test_an_attitude_is_likelier_where_the_whole_line_has_it() -> None:
    kinds, rows = ("smile", "brows_up"), ((0.9, 0.9), (0.3, 0.3))
    begins, goes_on = stretch_levels(kinds, np.array(rows, np.float32), [(0, 0), (1, 1)])
    assert begins.tolist() == pytest.approx([0.85, 0.9], abs=0.01)
    assert goes_on.tolist() == pytest.approx([0.4, 0.3], abs=0.01)


def test_words_without_text_have_no_stretch_and_nothing_is_made() -> None:
    texts = ["", ""]
    assert stretches_of(texts) == []
    assert list(spans_of(("smile", "nod"), np.full((2, 2), 0.9, np.float32), stretches_of(texts), THRESHOLDS)) == []


def test_an_attitude_ends_where_it_is_not_likely_or_another_face_is_clear() -> None:
    assert spans_of_two(("smile",), (0.9,), (0.04,)) == {("smile", 0, 1)}
    assert spans_of_two(("smile", "sad"), (0.9, 0.0), (0.2, 0.9)) == {("smile", 0, 1), ("sad", 2, 3)}
    assert ("smile", 2, 3) in spans_of_two(("smile", "brows_up"), (0.9, 0.0), (0.2, 0.9))


def test_what_is_held_goes_on_over_the_phrases_of_a_sentence_and_what_is_done_is_done_again() -> None:
    tilts = [Span("tilt", first, first + 2, 0.4, first + 1) for first in (0, 3, 6)]
    nods = [Span("nod", first, first + 2, 0.4, first) for first in (0, 3)]
    going_on = [each for each in held([*tilts, *nods], {5}) if each.kind == "tilt"]
    assert going_on == [replace(tilts[0], last=5), tilts[2]]
    assert [each for each in held([*tilts, *nods], {5}) if each.kind == "nod"] == nods


def test_an_attitude_is_held_over_the_end_of_a_sentence() -> None:
    smiles = [Span("smile", first, first + 2, 0.4, first) for first in (0, 3)]
    assert list(held(smiles, {2})) == [replace(smiles[0], last=5)]


def test_nothing_is_held_for_longer_than_is_natural() -> None:
    half = MOST_HELD // 2
    smiles = [Span("smile", first, first + half - 1, 0.4, first) for first in (0, half, MOST_HELD)]
    assert [(each.first, each.last) for each in held(smiles, ())] == [
        (0, MOST_HELD - 1),
        (MOST_HELD, MOST_HELD + half - 1),
    ]
