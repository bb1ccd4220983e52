"""From candidates to a timed schedule (paper §3.4, §3.5): what is done, when it begins, strikes and ends, with which
hand.

How a movement is timed by its word is in `timing/anchoring.py`, which alternatives are taken in
`choosing.py`, what does not fit together is settled in `timing/conflicts.py`, how gestures are joined in
`timing/transitions.py`, what the body does by itself is in `idle/idle_behaviors.py`.
"""

from collections.abc import Iterable
from dataclasses import replace
from types import MappingProxyType

from ...model import Behavior, BehaviorCandidates, Channel, Interval, Level, Mode, Utterance
from ..characters.overlays import Character
from ..idle.idle_behaviors import idle_behaviors
from ..idle.saccades import TALKING
from ..idle.stillness import to_thousandths
from ..reading.player import Ban, banned
from ..timing.anchoring import PlacedBehavior, interval_of, placed_idle
from ..timing.conflicts import Kept, resolve
from ..timing.transitions import eased
from .attempts import ChoiceContext
from .choosing import choose
from .filling import FillingContext, fillers
from .modes import in_mode
from .necessity import BLINK, needed

PLANNED_MORE = 1.6
"""Ideas crowd in some lines and are absent from others: a planned line may have this many times the usual gestures."""

ASKED_MORE = MappingProxyType({Level.LOW: 3.6, Level.MEDIUM: 4.0, Level.HIGH: 4.6})
"""How many times the usual gestures functions may ask for by priority alone, as in the paper's Figure 8: in the usual
character a stroke every .7 s. Agitation drives the quantity (§1)."""

PAUSE_S = 0.5
"""A line has its share of the pause between lines. It makes up for the gestures that find no place in their line, so
that the rates of `benchmarks/bml/schedule.py` come out as set."""


def schedule(
    candidates: Iterable[BehaviorCandidates],
    utterance: Utterance,
    character: Character,
    *,
    seed: int,
    mode: Mode = Mode.SEMANTIC,
    several_listeners: bool = False,
    bans: tuple[Ban, ...] = (),
) -> tuple[Behavior, ...]:
    """The behaviours in order of time, those that were dropped among them; none at all when no word has a time.

    Head, eyes and face are the same in every mode. The kept ones do not overlap on a channel (or hand), and their sync
    points are in order and not before 0.
    """
    timed = tuple(word for word in utterance.words if word.interval is not None)
    if not timed:
        return ()
    duration_s = utterance.duration_s or interval_of(timed[-1]).end_s
    candidates = tuple(candidates)
    planned = any(each.moment and not each.moment.demanded for each in candidates)
    spoken_s = duration_s - utterance.lead_in_s
    at_rate = most_gestures(character, spoken_s * (PLANNED_MORE if planned else 1.0))
    level = utterance.level
    most_asked = most_gestures(character, spoken_s * ASKED_MORE[level])
    line = ChoiceContext(timed, character, at_rate + _second_places(candidates), most_asked, bans)
    kept, lost = choose(candidates, line)
    kept, needless = needed(kept, candidates)
    usual = replace(line, most_gestures=most_gestures(character, spoken_s))
    kept, lost = in_mode(mode, (kept, (*lost, *needless)), usual, seed)
    kept, own_lost = resolve(_idle(kept, utterance, usual, seed, several_listeners=several_listeners), kept)
    kept = eased(kept)
    rest = FillingContext.of(utterance, timed, character, f"{seed} rest", bans)
    kept += fillers(kept, rest, replace(TALKING, eye_contact=character.eye_contact))
    return numbered([*(candidate.behavior for candidate in kept), *lost, *own_lost])


def _idle(
    kept: Kept, utterance: Utterance, line: ChoiceContext, seed: int, *, several_listeners: bool
) -> list[PlacedBehavior]:
    """What the body does by itself beside the kept, and nobody forbids."""
    character = line.character
    gazes = [each.behavior.sync for each in kept if each.behavior.kind is Channel.GAZE]
    looks = [Interval(sync.start, sync.end) for sync in gazes]
    blinks_asked_s = [each.placing.at_s for each in kept if each.behavior.lexeme == BLINK]
    behaviors = idle_behaviors(
        utterance,
        line.timed,
        seed,
        rest_poses=character.rest_poses,
        blinks_asked_s=blinks_asked_s,
        turning_beside=looks if several_listeners else None,
    )
    return [
        placed_idle(each, character.entries[each.name], f"own.{number:04d}")
        for number, each in enumerate(behaviors)
        if not banned(line.bans, each.name, each.word, each.word)
    ]


def most_gestures(character: Character, duration_s: float) -> int:
    """How many gestures the character makes at most in a line of this length, with the pause that goes with a line."""
    return round(character.gestures_per_minute * (duration_s + PAUSE_S) / 60)


def _second_places(candidates: Iterable[BehaviorCandidates]) -> int:
    """Contrasts whose second place is shown: it is one idea with the first, and the rate allows both or neither."""
    moments = (each.moment for each in candidates if each.moment)
    return sum(moment.set_against is not None and moment.set_against < moment.stroke for moment in moments)


def numbered(behaviors: Iterable[Behavior]) -> tuple[Behavior, ...]:
    """The behaviours in order of time, their ids such as `gesture1` in that order."""
    in_time = sorted(behaviors, key=lambda behavior: (behavior.sync.start, not behavior.kept, behavior.id))
    counts = dict.fromkeys(Channel, 0)
    names = {}
    for behavior in in_time:
        counts[behavior.kind] += 1
        names[behavior.id] = f"{behavior.kind}{counts[behavior.kind]}"
    return tuple(
        replace(
            behavior,
            id=names[behavior.id],
            lost_to=behavior.lost_to and names[behavior.lost_to],
            amount=behavior.amount if behavior.amount is None else to_thousandths(behavior.amount),
        )
        for behavior in in_time
    )
