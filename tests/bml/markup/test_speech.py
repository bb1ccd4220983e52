"""Times relative to sync marks equal times in seconds, and keep a behaviour's phases together."""

from dataclasses import replace
from itertools import pairwise

import pytest
from lxml import etree

from tests.bml.writing.test_writer import everything
from tests.support.bml.bml_checker import check
from tests.support.words.by_hand import spoken
from understudy.bml.markup.documents import Document, Element, Reference
from understudy.bml.markup.speech import FIRST_MOMENT_S, time_formatter
from understudy.bml.writing.writer import to_document, write_bml
from understudy.model import SyncPoints
from understudy.model.formats import BmlForm, TimeForm

SYNC = BmlForm(timing=TimeForm.SYNC)
STROKE = SyncPoints(start=1.3, ready=1.45, stroke_start=1.5, stroke=1.6, stroke_end=1.7, relax=2.0, end=3.25)


def told(sync: SyncPoints) -> dict[str, Reference]:
    """The points, with words beginning at 1.0, 1.4 and 1.8."""
    times = time_formatter(spoken("one two three"), TimeForm.SYNC, "w{}".format)(sync)
    return {name: time for name, time in times.items() if isinstance(time, Reference)}


def test_all_points_are_told_from_the_word_of_the_stroke() -> None:
    points = told(STROKE)
    assert {(point.behavior, point.point) for point in points.values()} == {("speech1", "w1")}
    assert (points["start"].offset_s, points["stroke"].offset_s, points["end"].offset_s) == (-0.1, 0.2, 1.85)


@pytest.mark.parametrize(("start_s", "mark"), [(0.2, "start"), (1.0, "w0"), (1.399, "w0"), (1.4, "w1"), (9.0, "w2")])
def test_without_a_stroke_they_are_told_from_the_word_of_the_start(start_s: float, mark: str) -> None:
    point = told(SyncPoints(start=start_s, end=start_s + 1))["start"]
    assert point.point == mark


def test_what_comes_before_the_speech_is_told_from_its_start() -> None:
    times = time_formatter(spoken("one two"), TimeForm.SYNC, "w{}".format, speech_start_s=0.8)
    assert times(SyncPoints(start=0.3, end=1.2))["start"] == Reference("speech1", "start", -0.5)
    assert times(SyncPoints(start=0.9, end=1.2))["end"] == Reference("speech1", "start", 0.4)


@pytest.mark.parametrize("stroke_s", [0.6, 0.65, 0.7, 0.9])
def test_nothing_resolves_below_a_thousandth(stroke_s: float) -> None:
    """A realizer that adds up decimals drops what then begins at -5.6e-17 s."""
    words = spoken("one two three", start_s=0.05)
    starts = {f"w{word.index}": word.interval.start_s for word in words if word.interval}
    sync = SyncPoints(start=0.0, ready=0.0, stroke_start=0.0004, stroke=stroke_s, relax=1.0, end=1.5)
    times = time_formatter(words, TimeForm.SYNC, "w{}".format)(sync)
    resolved = [starts[time.point] + time.offset_s for time in times.values() if isinstance(time, Reference)]
    assert [round(time_s, 3) for time_s in resolved] == [0.001, 0.001, 0.001, stroke_s, 1.0, 1.5]
    assert min(resolved) > 0


def test_words_without_a_time_are_passed_over() -> None:
    words = (*spoken("one two"), replace(spoken("one two three")[2], interval=None))
    times = time_formatter(words, TimeForm.SYNC, "w{}".format)(SyncPoints(start=2.0, end=3.0))
    assert times["start"] == Reference("speech1", "w1", 0.6)


def test_every_time_is_the_same_as_in_seconds() -> None:
    whole = everything()
    starts = {f"w{word.index}": word.interval.start_s for word in whole.utterance.words if word.interval}
    absolute, sync = to_document(whole), to_document(whole, SYNC)
    for told_s, told_from in zip(_behaviors(absolute), _behaviors(sync), strict=True):
        for name, value in told_from.attributes.items():
            seconds = told_s.attributes[name]
            if isinstance(value, Reference):
                asked_s = max(FIRST_MOMENT_S, float(str(seconds)))
                assert starts.get(value.point, 0.0) + value.offset_s == pytest.approx(asked_s, abs=1e-9)
            else:
                assert value == seconds


def test_the_checker_takes_them() -> None:
    document = write_bml(everything(), SYNC)
    assert check(document) == []
    starts = [element.get("start", "") for element in etree.fromstring(document)][1:]
    assert all(start.startswith("speech1:") for start in starts)


def test_points_stay_in_order() -> None:
    offsets = [point.offset_s for point in told(STROKE).values()]
    assert all(earlier <= later for earlier, later in pairwise(offsets))


def _behaviors(document: Document) -> list[Element]:
    return list(document.root.children)[1:]
