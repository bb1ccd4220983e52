"""What is heard of a directed delivery while the reader is trained."""

import random
from itertools import pairwise

import pytest

from training.acting.directed import DirectedLine
from training.acting.listening import as_written, heard, voices_of
from understudy.behavior.reading.encoder import WORDS_ALONE, Delivery
from understudy.model import Affect, LineAffect, Tone

WORDS = ("I", "never", "said", "she", "took", "the", "money.")
MOMENT = {"first": 0, "last": 2, "stroke": 1, "importance": 3, "gesture": ["negation"], "face": ["frown"]}
LINE = DirectedLine("own-a-0", WORDS, {"id": "own-a-0", "moments": [MOMENT]})
ANGRY = DirectedLine(
    "x-a", WORDS, {"id": "x-a", "base": "x", "focus": [3], "tone": "angry", "loudness": 1, "moments": []}, careful=True
)


def _many(line: DirectedLine, count: int = 400) -> list[Delivery]:
    chance = random.Random(0)
    return [heard(line, {}, chance) for _ in range(count)]


def test_the_focus_is_mostly_found_and_not_always() -> None:
    chance = random.Random(0)
    found = [shares.index(max(shares)) == 3 for _ in range(400) if (shares := as_written(ANGRY, {}, chance).focus)]
    assert 0.8 < sum(found) / len(found) < 1


def test_the_tone_is_mostly_heard_and_not_always() -> None:
    chance = random.Random(0)
    tones = [affect.line.tone for _ in range(400) if (affect := as_written(ANGRY, {}, chance).affect)]
    assert 0.55 < tones.count(Tone.ANGRY) / len(tones) < 0.95


@pytest.mark.parametrize("line", [LINE, ANGRY])
def test_whatever_is_heard_is_a_delivery_of_the_line(line: DirectedLine) -> None:
    for each in _many(line):
        assert each.focus is None or (len(each.focus) == len(WORDS) and sum(each.focus) == pytest.approx(1))
        assert each.affect is None or sum(each.affect.line.tones) == pytest.approx(1)
        assert each.loudness is None or -1 <= each.loudness <= 1


def test_parts_of_a_delivery_are_left_out_at_times() -> None:
    several = _many(ANGRY)
    assert 0.1 < several.count(WORDS_ALONE) / len(several) < 0.4
    assert any(each.focus is None and each.affect is not None for each in several)


def test_a_line_without_a_delivery_is_mostly_read_without_one() -> None:
    assert _many(LINE).count(WORDS_ALONE) > 0.4 * 400


def test_affect_is_mostly_heard_as_it_was_measured_in_the_same_tone() -> None:
    loud = Delivery(affect=LineAffect(Affect(0.9, -0.9, 0.9)), loudness=0.95)
    voices = voices_of({"x-a": [loud] * 6}, [ANGRY, LINE])
    chance = random.Random(0)
    several = [as_written(ANGRY, voices, chance) for _ in range(200)]
    assert 0.5 < sum(each.affect == loud.affect for each in several) / len(several) < 0.9
    assert all(each.focus is not None for each in several)


def test_chance_alone_decides() -> None:
    assert _many(ANGRY, 5) == _many(ANGRY, 5)
    assert any(first != second for first, second in pairwise(_many(ANGRY, 5)))
