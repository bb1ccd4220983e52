"""The three performances of the paper's study (§5): gestures from the meaning, from the stress, or from chance.

Head, eyes and face are those of the meaning in all three, so that a comparison of them compares the gestures.
"""

import random
from collections.abc import Iterable
from dataclasses import replace

from ...model import Behavior, BehaviorCandidates, Channel, Mode, Movement
from .candidates import PlacedBehavior, asked
from .choosing import Line, with_hand
from .conflicts import Fitted, Kept, fitted

BEAT = "beat_gesture"
STRESSED = "emphasis"
"""The class of the functions that the voice's stress makes."""

DRAWS = 8
"""How often chance tries for a gesture that fits."""


def in_mode(
    mode: Mode,
    chosen: tuple[Kept, tuple[Behavior, ...]],
    candidates: Iterable[BehaviorCandidates],
    line: Line,
    seed: int,
) -> tuple[Kept, tuple[Behavior, ...]]:
    """What is kept and lost in a mode, from what was chosen by meaning."""
    if mode is Mode.SEMANTIC:
        return chosen
    kept, lost = chosen
    gestures = [each for each in kept if each.behavior.kind is Channel.GESTURE]
    kept = tuple(each for each in kept if each.behavior.kind is not Channel.GESTURE)
    lost = tuple(behavior for behavior in lost if behavior.kind is not Channel.GESTURE)
    replaced = (replace(each.behavior, kept=False, reason=f"not in the mode {mode}") for each in gestures)
    if mode is Mode.PROSODY:
        return _beaten_in(kept, candidates, line), (*lost, *replaced)
    return _drawn(kept, gestures, line, random.Random(f"{seed} {len(line.timed)} gestures")), (*lost, *replaced)


def _beaten_in(kept: Kept, candidates: Iterable[BehaviorCandidates], line: Line) -> Kept:
    """Beats on the stressed words, as many as the character makes."""
    stressed = sorted(
        (offer.function for offer in candidates if offer.function and offer.function.class_name == STRESSED),
        key=lambda function: (-function.priority, function.first),
    )
    left = line.most_gestures
    for function in stressed:
        movement = Movement(BEAT, function.first, function.last, function.priority, "", function.id)
        outcome = _fitted(movement, kept, line, "beats on a stressed word")
        if left and outcome is not None:
            kept, left = outcome.kept, left - 1
    return kept


def _drawn(kept: Kept, gestures: list[PlacedBehavior], line: Line, generator: random.Random) -> Kept:
    """A gesture of the table, whichever, in place of each."""
    names = [name for name, entry in line.character.entries.items() if entry.channel is Channel.GESTURE]
    for each in gestures:
        behavior = each.behavior
        for name in generator.choices(names, k=DRAWS):
            movement = Movement(name, behavior.first, behavior.last, behavior.priority, "", None)
            outcome = _fitted(movement, kept, line, "drawn by chance")
            if outcome is not None:
                kept = outcome.kept
                break
    return kept


def _fitted(movement: Movement, kept: Kept, line: Line, reason: str) -> Fitted | None:
    name = f"{movement.name}.{movement.first}.{movement.last}"
    candidate = asked(movement, line.character.entries[movement.name], line.timed, name)
    if not candidate.behavior.kept:
        return None
    behavior = replace(candidate.behavior, rule=None, reason=reason)
    candidate = with_hand(replace(candidate, behavior=behavior), kept, line.character.handedness)
    outcome = fitted(candidate, kept)
    return outcome if isinstance(outcome, Fitted) else None
