"""`lexicon/phone_durations.yaml`, and mistakes in it."""

from pathlib import Path

import pytest

from understudy.acoustic.pacing.phone_durations import FILE, LABELS, PhoneDurations
from understudy.errors import AuthoringError
from understudy.files import resource_folder
from understudy.model import Interval, Phone, Word

SHIPPED = resource_folder("lexicon") / FILE


def test_the_shipped_durations_are_those_of_speech() -> None:
    durations = PhoneDurations.load(SHIPPED)
    assert durations.usual_s.keys() == LABELS
    assert all(0.02 < each < 0.25 for each in durations.usual_s.values())
    assert durations.usual_s["AY"] > durations.usual_s["AH"] > durations.usual_s["DH"]


def test_sounds_share_a_word_in_proportion_and_without_gaps() -> None:
    durations = PhoneDurations({"N": 0.05, "OW": 0.15})
    phones = tuple(Phone(label, Interval(0.0, 0.0)) for label in ("N", "OW"))
    word = durations.spread(Word(0, "no", phones=phones), Interval(1.0, 1.8))
    assert [phone.interval for phone in word.phones] == [Interval(1.0, 1.2), Interval(1.2, 1.8)]
    assert durations.spread(Word(0, "—"), Interval(1.0, 1.8)).phones == ()


@pytest.mark.parametrize(
    ("old", "new", "told", "line"),
    [
        ("AA: 0.128", "AX: 0.128", "no speech sound is called 'AX'", 4),
        ("AA: 0.128", "AA: 0", "greater than 0", 4),
        ("AA: 0.128", "AA: long", "number", 4),
        ("AA: 0.128", "", "AA are missing", 1),
    ],
)
def test_mistakes_are_told_with_their_place(tmp_path: Path, old: str, new: str, told: str, line: int) -> None:
    text = SHIPPED.read_text(encoding="utf-8")
    assert old in text
    (tmp_path / FILE).write_text(text.replace(old, new), encoding="utf-8")
    with pytest.raises(AuthoringError) as raised:
        PhoneDurations.load(tmp_path / FILE)
    assert any(told in each.message for each in raised.value.mistakes)
    assert {each.line for each in raised.value.mistakes} >= {line} or line == 1
