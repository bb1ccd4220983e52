"""The lead-in: a performance may begin before its recording, so that there is time to prepare the first word's gesture.

With a lead-in, all times are on the clock of the performance (of its BML block), on which the recording starts at
`lead_in_s`. Times are seconds.
"""

from dataclasses import replace

from .language import Utterance
from .voice.speech import Interval, Word

_DECIMALS = 6
"""Keeps whole milliseconds exact under addition."""


def with_lead_in(utterance: Utterance, lead_in_s: float) -> Utterance:
    """The utterance on the clock of a performance that begins `lead_in_s` before its recording, whatever its present
    lead-in; with 0 the clock is the recording's own. Whole milliseconds, as in BML."""
    lead_in_s = round(lead_in_s, 3)
    delay_s = lead_in_s - utterance.lead_in_s
    if not delay_s:
        return utterance
    return replace(
        utterance,
        words=tuple(later_word(word, delay_s) for word in utterance.words),
        fillers=tuple(replace(each, interval=_later(each.interval, delay_s)) for each in utterance.fillers),
        duration_s=None if utterance.duration_s is None else later_s(utterance.duration_s, delay_s),
        lead_in_s=lead_in_s,
    )


def later_word(word: Word, delay_s: float) -> Word:
    """The word shifted by `delay_s`."""
    if not delay_s or word.interval is None:
        return word
    phones = tuple(replace(phone, interval=_later(phone.interval, delay_s)) for phone in word.phones)
    return replace(word, interval=_later(word.interval, delay_s), phones=phones)


def later_s(time_s: float, delay_s: float) -> float:
    """The time shifted by `delay_s`; exactly the same if that is 0."""
    return round(time_s + delay_s, _DECIMALS) if delay_s else time_s


def _later(interval: Interval, delay_s: float) -> Interval:
    return Interval(later_s(interval.start_s, delay_s), later_s(interval.end_s, delay_s))
