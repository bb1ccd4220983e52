"""Candidates (NGS §3.3, steps 1 to 3): the words on which strokes may fall, and the candidate gestures of each. The
playable gestures are those of the behaviour table, without those that a line forbids.

A gesture is a candidate for a tag if it is probable enough among the gestures that accompany the tag (the paper
requires P(g∣s) > .1). Its stroke may fall on the tag's last word, and, if the tag is in the rheme of its segment, on
the focus. The rheme is the part of the segment from its first verb on; the focus is the most emphasised word of the
rheme, the last of equals. In the paper both are annotated manually.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

from ...model import Hand, Interval, Utterance, Word
from ...model.limits import Forms
from ..annotation.model import TaggedWords
from ..profile import Profile, TagHabit
from ..segments import segments_of, time_of


@dataclass(frozen=True, slots=True)
class PlayableGesture:
    """A playable lexeme: its forms by hand, the duration of its stroke and the share of it before the emphasis, its
    size in [0, 1], and the lemmas of which one must occur nearby (empty: none is required)."""

    forms: Mapping[Hand, Forms]
    stroke_s: float
    emphasis: float
    amount: float | None = None
    lemmas: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class ClosedWords:
    """The words from `first` to `last`, on which no gesture of `lexemes` (None: no gesture at all) may fall."""

    first: int
    last: int
    lexemes: Collection[str] | None = None

    def closes(self, word: int, lexeme: str) -> bool:
        """Whether a stroke of the lexeme on the word is forbidden."""
        return self.first <= word <= self.last and (self.lexemes is None or lexeme in self.lexemes)


@dataclass(frozen=True, slots=True)
class Repertoire:
    """The playable gestures by lexeme, the closed words, and the times at which other gestures use the hands."""

    gestures: Mapping[str, PlayableGesture]
    closed: tuple[ClosedWords, ...] = ()
    taken: tuple[Interval, ...] = ()

    def allows(self, lexeme: str, word: int, lemmas: Collection[str]) -> bool:
        """Whether the lexeme may be made on a word with these lemmas nearby."""
        gesture = self.gestures.get(lexeme)
        if gesture is None or any(each.closes(word, lexeme) for each in self.closed):
            return False
        return not gesture.lemmas or not gesture.lemmas.isdisjoint(lemmas)


THRESHOLD = 0.02

VERB_PHRASE = "initial_verb_phrase"
"""The tag of the first verb of a clause, at which the rheme begins."""

LEMMAS_NEAR = 2
"""The largest distance, in words, of a lemma that a gesture requires (as in the plan of moments)."""


@dataclass(frozen=True, slots=True)
class StrokeWord:
    """A word on which a stroke may fall: its end, its segment, the probability of each lexeme, and the most probable
    tag for each lexeme with the tag's words."""

    word: int
    end_s: float
    segment: int
    weights: Mapping[str, float]
    tags: Mapping[str, TaggedWords]


def places_of(
    profile: Profile, repertoire: Repertoire, utterance: Utterance, tags: Sequence[TaggedWords]
) -> tuple[StrokeWord, ...]:
    """The places of a line in order of time, without those that have no candidate."""
    words = {word.index: word for word in utterance.words if word.interval is not None}
    segments = segments_of(utterance.words)
    lemmas = _lemmas(utterance)
    found: dict[int, dict[str, list[tuple[float, TaggedWords]]]] = {}
    for tag in tags:
        habit, on = profile.tag(tag.tag), tuple(_words_for(tag, segments, words, tags))
        for word, (lexeme, likely) in product(on, _candidates(habit) if habit else ()):
            if repertoire.allows(lexeme, word, _near(lemmas, word)):
                found.setdefault(word, {}).setdefault(lexeme, []).append((likely / len(on), tag))
    return tuple(
        StrokeWord(
            word=word,
            end_s=time_of(words[word]).end_s,
            segment=_segment(segments, word),
            weights={lexeme: sum(likely for likely, _tag in shown) for lexeme, shown in found[word].items()},
            tags={lexeme: max(shown, key=lambda each: each[0])[1] for lexeme, shown in found[word].items()},
        )
        for word in sorted(found)
    )


def _candidates(habit: TagHabit) -> Iterator[tuple[str, float]]:
    """The gestures that are probable enough with a tag; the probability of the others is shared among them."""
    total = sum(habit.lexemes.values())
    likely = {lexeme: share for lexeme, share in habit.lexemes.items() if share > THRESHOLD * total}
    scale = total / sum(likely.values()) if likely else 0.0
    yield from ((lexeme, scale * share) for lexeme, share in likely.items())


def _words_for(
    tag: TaggedWords, segments: Sequence[tuple[int, int]], words: Mapping[int, Word], tags: Sequence[TaggedWords]
) -> Iterable[int]:
    """The tag's last word, and the focus of the rheme that contains it."""
    own = [word for word in range(tag.first, tag.last + 1) if word in words]
    if not own:
        return ()
    first, last = segments[_segment(segments, own[-1])]
    verbs = [each.first for each in tags if each.tag == VERB_PHRASE and first <= each.first <= last]
    rheme = [word for word in range(min(verbs, default=first), last + 1) if word in words]
    if own[-1] not in rheme or not any(words[word].emphasis for word in rheme):
        return (own[-1],)
    focus = max(reversed(rheme), key=lambda word: words[word].emphasis or 0.0)
    return dict.fromkeys((own[-1], focus))


def _segment(segments: Sequence[tuple[int, int]], word: int) -> int:
    return next(number for number, (first, last) in enumerate(segments) if first <= word <= last)


def _lemmas(utterance: Utterance) -> Mapping[int, set[str]]:
    lemmas: dict[int, set[str]] = {}
    for token in utterance.parse.tokens:
        lemmas.setdefault(token.word, set()).add(token.lemma.lower())
    return lemmas


def _near(lemmas: Mapping[int, set[str]], word: int) -> Collection[str]:
    about = range(word - LEMMAS_NEAR, word + LEMMAS_NEAR + 1)
    return set[str]().union(*(lemmas.get(each, set()) for each in about))
