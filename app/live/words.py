"""Known words of a live stream: the rules perform them, phrase by phrase, as soon as they arrive.

A speech synthesizer knows the times of its words; then nothing is aligned. Plain text gets usual durations. Times are
seconds of the stream.

Words with times are stressed as those of a recording are: by how long their syllables last, and by the voice where it
has been heard already; the focus is shared among the words that were heard. In the times of TIMIT's words alone lies
most of the stress (`python -m benchmarks.live.words`).
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

from ..acoustic.focus.focus_model import DECIMALS as FOCUS_DECIMALS
from ..acoustic.stage import measure_stress
from ..errors import InputError, shown
from ..model import Affect, Behavior, Interval, LineAffect, Phone, Utterance, Viseme, Word
from ..models import Understudy
from ..options import Options
from ..performance import perform_analysis
from ..rules.derivation import understand
from ..text.transcript import read_transcript
from .ear import RecentVoice
from .models import LiveModels

LEAD_IN_S = 0.6
"""How long before its first word a phrase may begin to move."""

BETWEEN_WORDS_S = 0.01
LONGEST_WORD_S = 30.0
"""The longest a word may last, even sung."""

LONGEST_SPAN_S = 600.0
"""From the first word of a message to the end of its last."""

OVERLAP_S = 0.001
"""Smaller overlaps of words are accepted: times are often rounded sums of durations."""

SOONEST_S = 0.15
"""A behaviour can still begin if its stroke or peak is at least this far ahead."""


@dataclass(frozen=True, slots=True)
class TimedText:
    """A written word and its interval."""

    text: str
    interval: Interval


@dataclass(frozen=True, slots=True)
class PerformedPhrase:
    """The behaviours and visemes of a phrase, from its first word to its last."""

    interval: Interval
    behaviors: tuple[Behavior, ...]
    visemes: tuple[Viseme, ...]
    words: tuple[Word, ...]


def timed_words(models: LiveModels, timed: tuple[TimedText, ...], recent: RecentVoice) -> tuple[Word, ...]:
    """Words in order, with their sounds over the time of each, and how stressed they are. Raises InputError for times
    that are not in order or too long, and as `read_transcript` does."""
    if any(not _is_one_word(each.text) for each in timed):
        raise InputError("value_wrong", "words: each text is one word, without white space", field="words")
    words = read_transcript(" ".join(each.text for each in timed))
    _require_order(timed)
    spoken = models.understudy.acoustic.aligner.pronounce(words)
    placed = tuple(models.durations.spread(word, each.interval) for word, each in zip(spoken, timed, strict=True))
    return _stressed(models, placed, recent)


def _require_order(timed: tuple[TimedText, ...]) -> None:
    """Raises InputError `value_wrong` for words that are not one after the other, or last longer than any can."""
    for before, after in pairwise(timed):
        if after.interval.start_s < before.interval.end_s - OVERLAP_S:
            message = f"words: {shown(after.text)} begins before {shown(before.text)} ends; send them in order"
            raise InputError("value_wrong", message, field="words")
    for each in timed:
        if each.interval.duration_s > LONGEST_WORD_S:
            message = f"words: {shown(each.text)} lasts {each.interval.duration_s:g} s; {LONGEST_WORD_S:g} s at most"
            raise InputError("value_wrong", message, field="words")
    span_s = timed[-1].interval.end_s - timed[0].interval.start_s
    if span_s > LONGEST_SPAN_S:
        message = f"words: they last {span_s:g} s; send {LONGEST_SPAN_S:g} s at most in a message"
        raise InputError("value_wrong", message, field="words")


def paced_words(models: LiveModels, text: str, start_s: float) -> tuple[Word, ...]:
    """The words of a text at a usual pace from then on; raises as `read_transcript` does, and InputError
    `transcript_unspoken`."""
    words = read_transcript(text)
    return tuple(_paced(models, models.understudy.acoustic.aligner.pronounce(words), start_s))


def perform_words(
    understudy: Understudy, words: tuple[Word, ...], options: Options, now_s: float, affect: Affect | None = None
) -> PerformedPhrase:
    """What the rules make of timed words, spoken with that feeling as far as it was heard, so far as it can still be
    begun. Raises InputError as `perform_analysis` does."""
    intervals = [word.interval for word in words if word.interval]
    spoken = Interval(intervals[0].start_s, intervals[-1].end_s)
    begin_s = spoken.start_s - LEAD_IN_S
    heard = tuple(_shifted(word, -begin_s) for word in words)
    utterance = Utterance(
        heard,
        understudy.language.parser.parse(heard),
        duration_s=spoken.end_s - begin_s,
        affect=None if affect is None else LineAffect(affect),
    )
    performance = perform_analysis(understudy, understand(understudy.language.rules, utterance), options)
    later = (replace(each, sync=each.sync.shifted(begin_s)) for each in performance.behaviors if each.kept)
    visemes = tuple(
        replace(each, interval=_moved(each.interval, begin_s))
        for each in performance.visemes
        if each.interval.end_s + begin_s > spoken.start_s
    )
    return PerformedPhrase(spoken, tuple(_in_time(later, now_s)), visemes, words)


def _in_time(behaviors: Iterator[Behavior], now_s: float) -> Iterator[Behavior]:
    """Those that can be begun now or later; one whose beginning has passed is begun now."""
    for each in behaviors:
        sync = each.sync
        aim_s = next(at_s for at_s in (sync.stroke_start, sync.ready, sync.start) if at_s is not None)
        if sync.start >= now_s:
            yield each
        elif aim_s >= now_s + SOONEST_S:
            yield replace(each, sync=replace(sync, start=round(now_s, 3)))


def _stressed(models: LiveModels, words: tuple[Word, ...], recent: RecentVoice) -> tuple[Word, ...]:
    intervals = [word.interval for word in words if word.interval]
    begin_s, end_s = intervals[0].start_s, intervals[-1].end_s
    on_clock = tuple(_shifted(word, -begin_s) for word in words)
    stressed, _ = measure_stress(models.understudy.acoustic, on_clock, recent.during(begin_s, end_s))
    return _heard(tuple(_shifted(word, begin_s) for word in stressed), recent.until_s)


def _heard(words: tuple[Word, ...], until_s: float) -> tuple[Word, ...]:
    """The words with the focus shared among those that were heard; none if none was."""
    shares = [word.focus or 0.0 if word.interval and word.interval.end_s <= until_s else 0.0 for word in words]
    total = sum(shares)
    heard = [round(share / total, FOCUS_DECIMALS) if total else None for share in shares]
    return tuple(replace(word, focus=share) for word, share in zip(words, heard, strict=True))


def _is_one_word(text: str) -> bool:
    return len(text.split()) == 1


def _paced(models: LiveModels, words: tuple[Word, ...], start_s: float) -> Iterator[Word]:
    for word in words:
        end_s = start_s + models.durations.of(word.phones)
        yield models.durations.spread(word, Interval(round(start_s, 3), round(end_s, 3)))
        start_s = end_s + BETWEEN_WORDS_S


def _shifted(word: Word, by_s: float) -> Word:
    assert word.interval is not None, "every word is timed"
    phones = tuple(Phone(each.label, _moved(each.interval, by_s), each.stress) for each in word.phones)
    return replace(word, interval=_moved(word.interval, by_s), phones=phones)


def _moved(interval: Interval, by_s: float) -> Interval:
    return Interval(round(interval.start_s + by_s, 3), round(interval.end_s + by_s, 3))
