"""Words, utterances, functions and movements made by hand, for tests that need no audio, parser or models."""

from collections.abc import Sequence
from dataclasses import replace

from understudy.model import (
    Agitation,
    Alternative,
    BehaviorCandidates,
    Function,
    Interval,
    Level,
    Movement,
    Parse,
    Phone,
    Phrase,
    Utterance,
    Word,
)

FIGURE_8 = "I guess not, I think I must've misread all of those signals."


def spoken(text: str, *, start_s: float = 1.0, word_s: float = 0.4, stressed: Sequence[int] = ()) -> tuple[Word, ...]:
    """The words of `text`, `word_s` each without pauses; their one vowel takes the second half."""
    return tuple(
        _word(index, word, start_s + index * word_s, word_s, 1.0 if index in stressed else 0.0)
        for index, word in enumerate(text.split())
    )


def _word(index: int, text: str, start_s: float, word_s: float, emphasis: float) -> Word:
    middle_s, end_s = start_s + word_s / 2, start_s + word_s
    phones = (Phone("T", Interval(start_s, middle_s)), Phone("AH", Interval(middle_s, end_s), stress=1))
    return Word(index, text, Interval(start_s, end_s), phones, emphasis=emphasis)


def utterance(words: tuple[Word, ...], level: Level | None = None, phrase_ends: Sequence[int] = ()) -> Utterance:
    agitation = Agitation(**{each.value: float(each is level) for each in Level}) if level else None
    phrases = tuple(Phrase("noun", word, word, word) for word in phrase_ends)
    last = words[-1].interval
    return Utterance(words, Parse((), phrases, ()), agitation, duration_s=last.end_s + 0.2 if last else None)


def function(class_name: str, subtype: str, first: int, last: int, priority: float = 3.0) -> Function:
    return Function(f"{class_name}{first}", class_name, subtype, first, last, priority, "by_hand")


def movement(name: str, first: int, last: int | None = None, priority: float = 3.0) -> Movement:
    return Movement(name, first, first if last is None else last, priority, "by_hand", f"function{first}")


def offered(*movements: Movement, weight: float = 1.0, lot: float = 1.0) -> BehaviorCandidates:
    """A offer with one alternative, the movements together, as a function of the first movement's words has it."""
    first = movements[0]
    named = function("by_hand", "plain", first.first, first.last, first.priority)
    return BehaviorCandidates(replace(named, id=first.function or ""), (Alternative(movements, weight, lot),))


def figure_8() -> tuple[Function, ...]:
    """The functions of the paper's Figure 8, with priorities of the order its text gives them."""
    return (
        *(function("deixis", "self", word, word, 5) for word in (0, 3, 5)),
        function("initial_noun_phrase", "plain", 0, 0, 1),
        function("initial_verb_phrase", "plain", 1, 1, 1),
        function("emphasis", "plain", 1, 1, 2),
        function("negation", "plain", 2, 2, 6),
        function("quantification", "all", 8, 8, 4),
        function("deixis", "distal", 10, 11, 5),
    )
