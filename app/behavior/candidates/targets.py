"""Points at targets of the scene where words name them, with hand and eyes.

"The door", "that old door", "my car": a noun with a definite article, demonstrative or possessive before it, whose
words are those of a target's name (`front_door` is "front door"); or the name of a person ("Anna"). Demonstratives
point every time, all others only the first time in a line: a thing whose place is known need not be shown again.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import atan2, degrees

from ...model import (
    Alternative,
    BehaviorCandidates,
    Channel,
    Function,
    Moment,
    Movement,
    Target,
    Term,
    Token,
    Utterance,
)

DEMONSTRATIVES = frozenset({"this", "that", "these", "those"})
DEFINITE = DEMONSTRATIVES | {"the", "my", "your", "his", "her", "its", "our", "their"}
MOST_BETWEEN = 2
"""The most words between the determiner and the name: "that big old door"."""

ASIDE_DEG = 15.0
"""Beyond this angle the hand of that side points."""

LEFT, FRONT, RIGHT, LOOK = "gesture_point_left", "gesture_point_front", "gesture_point_right", "gaze_target"
RULE = "show_target"
PRIORITY = 9.5
"""Just below that of a moment with importance 1 (`candidates.PRIORITY_OF_SURE`)."""

_MARKS = (",", ";", ":", ".", "?", "!")
DEIXIS = "deixis"
_POINTED = frozenset({"distal", "proximal", "place"})


@dataclass(frozen=True, slots=True)
class Mention:
    """Words `first` to `last` name a target; the hand's stroke falls on `last`, its noun."""

    target: Target
    first: int
    last: int

    def overlaps(self, first: int, last: int) -> bool:
        return self.first <= last and first <= self.last


def mentions(utterance: Utterance, targets: Iterable[Target]) -> tuple[Mention, ...]:
    """The mentions of targets that are pointed at, in order, without overlaps."""
    found = sorted(
        (mention for target in targets for mention in _of_target(utterance, target)),
        key=lambda mention: (mention.first, -mention.target.name.count("_")),
    )
    shown: list[Mention] = []
    for mention in found:
        if not any(mention.overlaps(other.first, other.last) for other in shown):
            shown.append(mention)
    return tuple(shown)


def without_overlapped(
    candidates: Iterable[BehaviorCandidates], named: Sequence[Mention]
) -> tuple[BehaviorCandidates, ...]:
    """The candidates except those that point elsewhere, or gesture, on words that name a target."""
    return tuple(each for each in candidates if not any(_contradicts(each, mention) for mention in named))


def pointing_candidates(named: Iterable[Mention], functions: Sequence[Function] = ()) -> Iterator[BehaviorCandidates]:
    """A pointing gesture with a look for each mention, as a moment of the line, shown for the most important of the
    `functions` of its words."""
    for mention in named:
        of_words = [each for each in functions if each.kept and mention.overlaps(each.first, each.last)]
        function = max(of_words, key=lambda each: (each.class_name == DEIXIS, each.priority, each.id), default=None)
        name = mention.target.name
        moment = Moment(
            id=f"target.{name}.{mention.first}",
            channel=Channel.GESTURE,
            first=mention.first,
            last=mention.last,
            stroke=mention.last,
            families=("point_there",),
            importance=1.0,
            terms=(Term(f"the words name the target {name}", 1.0),),
        )
        movements = tuple(
            replace(_movement(mention, moment, behavior), function=function.id if function else None)
            for behavior in (_pointing(mention.target), LOOK)
        )
        yield BehaviorCandidates(None, (Alternative(movements, weight=1.0, lot=1.0),), moment)


def _of_target(utterance: Utterance, target: Target) -> Iterator[Mention]:
    tokens = utterance.parse.tokens
    parts = target.name.lower().split("_")
    shown = False
    for start in range(len(tokens) - len(parts) + 1):
        run = tokens[start : start + len(parts)]
        if not all(part in {token.text.lower(), token.lemma.lower()} for part, token in zip(parts, run, strict=True)):
            continue
        before = _determiner(utterance, start)
        demonstrative = before is not None and before.text.lower() in DEMONSTRATIVES
        named = before is None and all(token.part_of_speech == "PROPN" for token in run)
        if demonstrative or ((before is not None or named) and not shown):
            shown = True
            yield Mention(target, (before or run[0]).word, run[-1].word)


def _determiner(utterance: Utterance, start: int) -> Token | None:
    """The determiner before a noun, with at most modifiers of the noun between them."""
    for token in reversed(utterance.parse.tokens[max(0, start - MOST_BETWEEN - 1) : start]):
        if token.text.lower() in DEFINITE:
            return token
        describes = token.part_of_speech in {"ADJ", "NOUN", "NUM", "PROPN"}
        if not describes or utterance.words[token.word].text.endswith(_MARKS):
            return None
    return None


def _contradicts(offer: BehaviorCandidates, mention: Mention) -> bool:
    if offer.moment is not None:
        gestures = offer.moment.channel in {Channel.GESTURE, Channel.GAZE} and offer.moment.note is None
        return gestures and mention.overlaps(offer.moment.stroke, offer.moment.stroke)
    function = offer.function
    if function is None or function.given:
        return False
    points = function.class_name == DEIXIS and function.subtype in _POINTED
    return points and mention.overlaps(function.first, function.last)


def _pointing(target: Target) -> str:
    x_m, _y_m, z_m = target.position_m
    aside_deg = degrees(atan2(x_m, z_m))
    return FRONT if abs(aside_deg) < ASIDE_DEG else LEFT if aside_deg > 0 else RIGHT


def _movement(mention: Mention, moment: Moment, behavior: str) -> Movement:
    return Movement(
        name=behavior,
        first=mention.first,
        last=mention.last,
        priority=PRIORITY,
        rule=RULE,
        function=None,
        stroke=mention.last,
        moment=moment.id,
        target=mention.target.name,
        decided_by=moment.terms,
    )
