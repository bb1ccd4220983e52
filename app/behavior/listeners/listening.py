"""The behaviour of a listener while a line is spoken (paper §3.6): generic feedback, driven by the speaker.

The speaker's head movements are mirrored after half a second. Beyond the paper, the listener nods where the speaker
pauses or ends a phrase (Yngve's back channels), blinks there, and looks at the speaker by the statistics of people who
listen (`saccades.py`). The frequencies are measured: people leave most movements unanswered and most pauses without a
nod. Times are seconds of the speaker's audio.

They are read from `lexicon/acting/head_rates.yaml`.

Probabilities are in [0, 1], times seconds. The file is written by `training/head_rates.py`; all mistakes in it are
reported at once, with their places.
"""

import random
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from types import MappingProxyType

from pydantic import Field

from ...model import Behavior, Channel, Utterance, Word
from ...yaml_files import Entry, Source
from ..characters.overlays import Character
from ..choice.filling import FillingContext, fillers
from ..choice.scheduling import numbered
from ..idle.idle_behaviors import IdleBehavior, blinks
from ..idle.saccades import LISTENING
from ..reading.player import Ban, banned
from ..timing.anchoring import PlacedBehavior, placed_idle
from ..timing.conflicts import resolve
from ..timing.phases import Placing

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
    return PlacedBehavior(mirrored, Placing(timing, at_s, sync.end, stroked=True))


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
