"""Without a path the words are spread over the loud parts by their phones, or the text is refused as too long."""

import numpy as np
import pytest

from understudy.acoustic.alignment.spreading import spread
from understudy.errors import InputError
from understudy.model import SAMPLE_RATE_HZ, Audio, Interval, Phone, Word

NOWHERE = Interval(0.0, 0.0)


def _word(index: int, *labels: str) -> Word:
    return Word(index, "x", phones=tuple(Phone(label, NOWHERE) for label in labels))


def _audio(*loud: bool) -> Audio:
    """A second of noise for each True, of silence for each False."""
    noise = np.random.default_rng(0).uniform(-0.1, 0.1, (len(loud), SAMPLE_RATE_HZ))
    return Audio((noise * np.array(loud)[:, None]).ravel())


def test_words_get_time_by_their_phones_where_it_is_loud() -> None:
    (one, two), notices = spread(_audio(False, True, False, True), (_word(0, "W", "AH", "N"), _word(1, "T")))
    assert one.interval == Interval(1.0, 3.5)
    assert two.interval == Interval(3.5, 4.0)
    assert [phone.interval.start_s for phone in one.phones] == [1.0, 1.5, 3.0]
    assert [notice.code for notice in notices] == ["alignment_low_confidence"]
    assert "word 0 (x), 1 (x)" in notices[0].message
    assert one.spread
    assert two.spread


def test_more_than_anybody_can_say_is_refused() -> None:
    with pytest.raises(InputError) as caught:
        spread(_audio(True), (_word(0, *["AH"] * 26),))
    assert caught.value.code == "transcript_mismatch"
