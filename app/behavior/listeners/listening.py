"""The listeners of a line: which of them the speaker addresses, where they are, and what each does (paper §3.6):
generic feedback, driven by the speaker.

The speaker's head movements are mirrored after half a second. Beyond the paper, the listener nods where the speaker
pauses or ends a phrase (Yngve's back channels), blinks there, and looks at the speaker by the statistics of people who
listen (`idle/idle_behaviors.py`). The frequencies are measured (`lexicon/acting/head_rates.yaml`, written by
`training/head_rates.py`): people leave most movements unanswered and most pauses without a nod. Probabilities are in
[0, 1]; all mistakes in the file are reported at once, with their places.

The input does not say to whom each sentence is addressed, so the speaker turns to the next listener when another
sentence begins, in the order in which they were named. Listeners without a target stand in an arc before the speaker,
with their eyes at average height, each at the distance of a conversation of two, or farther where they would touch.

Metres; seconds of the speaker's audio.
"""

import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import cos, pi, radians, sin
from pathlib import Path
from types import MappingProxyType

from pydantic import Field

from ...model import Behavior, Channel, Target, Utterance, Word
from ...model.tables import SHIFT
from ...model.targets import LISTENER
from ...yaml_files import Entry, Source
from ..characters.overlays import Character
from ..choice.filling import FillingContext, fillers
from ..choice.scheduling import numbered
from ..idle.idle_behaviors import LISTENING, IdleBehavior, blinks
from ..reading.player import Ban, banned
from ..timing.anchoring import PlacedBehavior, placed_idle
from ..timing.conflicts import resolve
from ..timing.phases import TimingBasis

DISTANCE_M = 1.25
EYES_M = 1.60
"""The default distance and eye height of a single listener (`understudy.realizer.head_and_gaze.gaze_targets`)."""

BETWEEN_DEG, WIDEST_DEG = 36.0, 120.0
ELBOW_ROOM_M = 0.70
"""The least distance between people who stand side by side."""

AT_THE_LISTENER = frozenset({"YOU", "OFFER"})
"""Gestures towards the person addressed."""


def placed_listeners(names: Sequence[str], targets: Sequence[Target]) -> tuple[Target, ...]:
    """The targets, and a place for each listener that has none, if there are several or the scene places one.

    Listeners without a place are distributed over the arc, the first on the speaker's left.
    """
    known = {target.name for target in targets}
    if len(names) < 2 and not known.intersection(names):
        return tuple(targets)
    unplaced = [name for name in names if name not in known]
    return (*targets, *(Target(name, place) for name, place in zip(unplaced, _arc(len(unplaced)), strict=True)))


def _arc(count: int) -> list[tuple[float, float, float]]:
    if count == 1:
        return [(0.0, EYES_M, DISTANCE_M)]
    between = radians(min(BETWEEN_DEG, WIDEST_DEG / max(count - 1, 1)))
    distance_m = max(DISTANCE_M, ELBOW_ROOM_M / (2 * sin(between / 2)))
    angles = [between * ((count - 1) / 2 - number) for number in range(count)]
    assert all(abs(angle) < pi / 2 for angle in angles), "all are before the speaker"
    return [(round(distance_m * sin(angle), 3), EYES_M, round(distance_m * cos(angle), 3)) for angle in angles]


def addressed(
    behaviors: Sequence[Behavior], listeners: Sequence[str], targets: Sequence[Target]
) -> tuple[Behavior, ...]:
    """The behaviours, those directed at the listener now directed at the addressee of their time; unchanged if no
    listener has a place."""
    known = {target.name for target in targets}
    placed = [name for name in listeners if name in known]
    if not placed:
        return tuple(behaviors)
    turns_s = [each.sync.start for each in behaviors if each.kept and _turns(each)]

    def addressee(time_s: float) -> str:
        turned = sum(turn_s <= time_s for turn_s in turns_s)
        return placed[max(0, turned - 1) % len(placed)]

    return tuple(
        replace(each, target=addressee(each.sync.start)) if _at_the_listener(each) else each for each in behaviors
    )


def _turns(behavior: Behavior) -> bool:
    return behavior.kind is Channel.GAZE and behavior.lexeme == SHIFT and behavior.target == LISTENER


def _at_the_listener(behavior: Behavior) -> bool:
    if behavior.kind is Channel.GESTURE:
        return behavior.lexeme in AT_THE_LISTENER and behavior.target is None
    return behavior.kind is Channel.GAZE and behavior.target == LISTENER


MIRROR_DELAY_S = 0.5
"""Paper §3.6."""

MIRRORED_SIZE = 0.6
"""The size of a mirrored movement relative to the speaker's."""

NOD = "small_nod"
SHORTEST_REACTION_S = 0.1
SHORTEST_BETWEEN_NODS_S = 2.5
SHORTEST_PAUSE_S = 0.2

PHRASE_ENDS = (".", ",", "?", "!", ";", ":")
"""Final characters of words that end a phrase without a pause; the rates were measured at such places."""

_SIDES: Mapping[str, str] = MappingProxyType({"LEFT": "RIGHT", "RIGHT": "LEFT"})


@dataclass(frozen=True, slots=True)
class HeadRates:
    """The probabilities of a nod at a speaker's pause, of one at punctuation without a pause, and of mirroring a head
    movement; the mean and standard deviation of a nod's delay after the end of the phrase."""

    nods_after_pause: float
    nods_after_phrase: float
    mirrored: float
    delay_s: float
    delay_spread_s: float

    @classmethod
    def load(cls, path: Path) -> "HeadRates":
        """Raises AuthoringError with every mistake."""
        return cls(**Source(path).validated(_HeadRatesFile).model_dump())


@dataclass(frozen=True, slots=True)
class Listener:
    """The listener's character, the rates of its head movements, the name of the speaker it looks at, and what it
    never does."""

    character: Character
    rates: HeadRates
    speaker: str
    bans: tuple[Ban, ...] = ()

    def never(self, name: str, word: int) -> bool:
        return banned(self.bans, name, word, word) is not None

    def never_moves(self, lexeme: str) -> bool:
        """Whether it makes no head movement with a lexeme."""
        entries = self.character.entries.items()
        return any(
            self.never(name, 0) for name, entry in entries if (entry.channel, entry.lexeme) == (Channel.HEAD, lexeme)
        )


def listen(
    behaviors: Iterable[Behavior], utterance: Utterance, listener: Listener, *, seed: int
) -> tuple[Behavior, ...]:
    """The listener's behaviours in order of time; none when no word has a time."""
    timed = tuple(word for word in utterance.words if word.interval is not None)
    if not timed:
        return ()
    character = listener.character
    luck = f"{seed} {character.name} listens"
    generator = random.Random(f"{luck} {' '.join(word.text for word in timed)}")
    mirrored = [
        _mirrored(behavior, character)
        for behavior in behaviors
        if _is_mirrored(behavior) and generator.random() < listener.rates.mirrored
    ]
    mirrored = [each for each in mirrored if not listener.never_moves(each.behavior.lexeme)]
    candidates = [
        IdleBehavior("gaze_opening", 0.0, timed[0].index, "looks at the speaker"),
        *_nods(timed, listener.rates, generator),
        *blinks(utterance, timed, luck),
    ]
    own = [
        placed_idle(idle, character.entries[idle.name], f"own.{number:04d}")
        for number, idle in enumerate(candidates)
        if not listener.never(idle.name, idle.word)
    ]
    kept, lost = resolve([*mirrored, *own])
    kept += fillers(kept, FillingContext.of(utterance, timed, character, luck, listener.bans), LISTENING)
    return tuple(
        replace(behavior, target=listener.speaker) if behavior.kind is Channel.GAZE else behavior
        for behavior in numbered([*(each.behavior for each in kept), *lost])
    )


def _is_mirrored(behavior: Behavior) -> bool:
    """Whether it is a head movement with a function; the speaker's drifts are not mirrored."""
    return behavior.kept and behavior.kind is Channel.HEAD and behavior.function is not None


def _mirrored(behavior: Behavior, listener: Character) -> PlacedBehavior:
    """The movement as in a mirror: the speaker's left becomes the listener's right."""
    lexeme = "_".join(_SIDES.get(part, part) for part in behavior.lexeme.split("_"))
    amount = None if behavior.amount is None else behavior.amount * MIRRORED_SIZE * listener.amplitude
    sync = behavior.sync.shifted(MIRROR_DELAY_S)
    mirrored = replace(
        behavior,
        id=f"mirrored.{behavior.id}",
        lexeme=lexeme,
        sync=sync,
        amount=None if amount is None else min(1.0, amount),
        rule=None,
        function=None,
        lost_to=None,
        reason=f"mirrors the speaker's {behavior.lexeme}",
    )
    timing = listener.entries[NOD].timing
    at_s = sync.stroke_end if sync.stroke_end is not None else sync.end
    return PlacedBehavior(mirrored, TimingBasis(timing, at_s, sync.end, stroked=True))


def _nods(timed: tuple[Word, ...], rates: HeadRates, generator: random.Random) -> Iterator[IdleBehavior]:
    """Nods at some of the places where the speaker pauses or ends a phrase, at random and not too close to each
    other."""
    last_s = -SHORTEST_BETWEEN_NODS_S
    for word, following in pairwise(timed):
        if word.interval is None or following.interval is None:
            continue
        end_s = word.interval.end_s
        pauses = following.interval.start_s - end_s >= SHORTEST_PAUSE_S
        if not pauses and not word.text.endswith(PHRASE_ENDS):
            continue
        nods = generator.random() < (rates.nods_after_pause if pauses else rates.nods_after_phrase)
        at_s = end_s + max(SHORTEST_REACTION_S, generator.gauss(rates.delay_s, rates.delay_spread_s))
        if nods and at_s >= last_s + SHORTEST_BETWEEN_NODS_S:
            reason = "nods as the speaker pauses" if pauses else "nods as the speaker's phrase ends"
            yield IdleBehavior(NOD, at_s, word.index, reason)
            last_s = at_s


class _HeadRatesFile(Entry):
    nods_after_pause: float = Field(ge=0, le=1)
    nods_after_phrase: float = Field(ge=0, le=1)
    mirrored: float = Field(ge=0, le=1)
    delay_s: float = Field(ge=0, le=5)
    delay_spread_s: float = Field(ge=0, le=5)
