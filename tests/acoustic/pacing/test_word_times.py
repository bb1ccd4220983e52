"""Words at usual times, on phones and tables made by hand."""

from pathlib import Path

import pytest

from understudy.acoustic.pacing.phone_durations import PhoneDurations
from understudy.acoustic.pacing.word_times import FILE, Pace, PacedWords, PauseTable, paced, timed_elsewhere
from understudy.errors import AuthoringError
from understudy.files import resource_folder
from understudy.model import PLAINLY_SPOKEN, Interval, Phone, Speaking, Word

SHIPPED = PauseTable.load(resource_folder("lexicon") / FILE)
TABLE = PauseTable(
    begin_s=0.5, end_s=1.0, between_words_s=0.0, pauses_s={",": 0.2, ".": 0.6, "—": 0.4}, before_pause=2, emphasized=1.5
)
PACE = Pace(PhoneDurations({"N": 0.1, "OW": 0.2}), TABLE)


def _words(text: str) -> tuple[Word, ...]:
    """Each is said "no", but what is punctuation alone."""
    said = tuple(Phone(label, Interval(0.0, 0.0)) for label in ("N", "OW"))
    return tuple(
        Word(index, word, phones=said if any(map(str.isalpha, word)) else ()) for index, word in enumerate(text.split())
    )


def _times_s(line: PacedWords) -> list[tuple[float, float] | None]:
    return [(word.interval.start_s, word.interval.end_s) if word.interval else None for word in line.words]


def test_sounds_last_as_usual_and_longer_before_a_pause() -> None:
    line = paced(PACE, _words("no no, no."), PLAINLY_SPOKEN)
    assert _times_s(line) == [(0.5, 0.8), (0.8, 1.3), (1.5, 2.0)]
    assert [phone.interval.duration_s for phone in line.words[1].phones] == pytest.approx([0.1, 0.4])
    assert line.duration_s == 3.0


def test_a_dash_alone_is_a_pause_and_lengthens_the_word_before_it() -> None:
    assert _times_s(paced(PACE, _words("no — no"), PLAINLY_SPOKEN)) == [(0.5, 1.0), None, (1.4, 1.9)]


def test_emphasis_rates_and_pauses_of_the_text_hold() -> None:
    speaking = Speaking(frozenset({0}), ((-1, 0.5), (1, 0.0)), ((1, 2.0),))
    line = paced(PACE, _words("no no, no"), speaking)
    assert _times_s(line) == [(1.0, 1.45), (1.45, 1.6), (1.6, 2.1)]


def test_a_full_stop_of_an_abbreviation_is_no_pause() -> None:
    assert _times_s(paced(PACE, _words("No. no"), PLAINLY_SPOKEN, {0}))[1] == (0.8, 1.3)


def test_a_synthesizers_words_share_their_times_among_their_sounds() -> None:
    expected = _words("no no")
    timed = tuple(Word(each.index, each.text, Interval(each.index * 1.0, each.index + 0.6)) for each in expected)
    line = timed_elsewhere(PACE, timed, expected)
    assert [phone.interval for phone in line.words[0].phones] == [Interval(0.0, 0.2), Interval(0.2, 0.6)]
    assert line.duration_s == 2.6
    own = tuple(line.words)
    assert timed_elsewhere(PACE, own, expected).words == own


@pytest.mark.parametrize(
    ("text", "pause_s"), [("so", 0), ("so,", 0.2), ('so."', 0.55), ("so...", 0.5), ("(so?!)", 0.55), ("—", 0.35)]
)
def test_the_longest_mark_at_the_end_says_how_long_the_pause_is(text: str, pause_s: float) -> None:
    assert SHIPPED.after(text) == pause_s


def test_every_mistake_of_the_table_is_told_with_its_place(tmp_path: Path) -> None:
    file = tmp_path / FILE
    text = (resource_folder("lexicon") / FILE).read_text(encoding="utf-8")
    file.write_text(text.replace('"!": 0.55', '"no": 0.55').replace("end_s: 0.5", "end_s: long"), encoding="utf-8")
    with pytest.raises(AuthoringError) as wrong:
        PauseTable.load(file)
    assert "'no' is not a punctuation mark" in str(wrong.value)
    assert len(wrong.value.mistakes) == 2
