"""The three conditions of the paper's study (§5): gestures from the meaning, from the stress, or from chance.

Head, eyes and face are those of the meaning in all three, so that a comparison of them compares the gestures. The two
rivals are made as good as possible: beats are spread over the stressed words of the whole line, and chance draws anew
for each text.
"""

import random
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from ...model import Behavior, Channel, Mode, Movement, Word
from ..reading.player import banned
from ..timing.anchoring import PlacedBehavior, asked
from ..timing.conflicts import FittedBehavior, Kept, fitted
from ..timing.time_index import TimeIndex
from .attempts import ChoiceContext
from .hands import with_hand

BEAT = "beat_gesture"
BEAT_PRIORITY = 1.0

DRAWS = 8
"""How many random gestures are tried until one fits."""


def in_mode(
    mode: Mode,
    chosen: tuple[Kept, tuple[Behavior, ...]],
    line: ChoiceContext,
    seed: int,
) -> tuple[Kept, tuple[Behavior, ...]]:
    """What is kept and lost in a mode, from what was chosen by meaning."""
    if mode is Mode.SEMANTIC:
        return chosen
    kept, lost = chosen
    gestures = [each for each in kept if each.behavior.kind is Channel.GESTURE]
    others = TimeIndex(each for each in kept if each.behavior.kind is not Channel.GESTURE)
    lost = tuple(behavior for behavior in lost if behavior.kind is not Channel.GESTURE)
    replaced = (replace(each.behavior, kept=False, reason=f"not in the mode {mode}") for each in gestures)
    if mode is Mode.PROSODY:
        return tuple(_beaten_in(others, line)), (*lost, *replaced)
    text = " ".join(word.text for word in line.timed)
    drawn = _drawn(others, gestures, line, random.Random(f"{seed} {text} gestures"))
    return tuple(drawn), (*lost, *replaced)


def _beaten_in(kept: TimeIndex, line: ChoiceContext) -> TimeIndex:
    """The kept with beats on stressed words, as many as the character makes, spread over the line."""
    stressed = [word for word in line.timed if word.is_emphasised]
    for part in _parts(stressed, line.most_gestures):
        kept = _beaten_once(kept, part, line)
    return kept


def _parts(stressed: Sequence[Word], most: int) -> list[Sequence[Word]]:
    """The stressed words in order, divided evenly into as many parts as there are beats; each part gets one beat."""
    count = min(most, len(stressed))
    bounds = [place * len(stressed) // count for place in range(count + 1)] if count else []
    return [stressed[first:last] for first, last in pairwise(bounds)]


def _beaten_once(kept: TimeIndex, part: Sequence[Word], line: ChoiceContext) -> TimeIndex:
    """The kept with a beat on the most stressed word of a part on which one fits; of equally stressed words the last,
    because English has its main stress late."""
    for word in sorted(part, key=lambda word: (-(word.emphasis or 0.0), -word.index)):
        movement = Movement(BEAT, word.index, word.index, BEAT_PRIORITY, "", None)
        outcome = _fitted(movement, kept, line, "beats on a stressed word")
        if outcome is not None:
            return outcome.kept
    return kept


def _drawn(kept: TimeIndex, gestures: list[PlacedBehavior], line: ChoiceContext, generator: random.Random) -> TimeIndex:
    """The kept with a random gesture of the table in place of each gesture."""
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


def _fitted(movement: Movement, kept: TimeIndex, line: ChoiceContext, reason: str) -> FittedBehavior | None:
    if banned(line.bans, movement.name, movement.first, movement.last):
        return None
    name = f"{movement.name}.{movement.first}.{movement.last}"
    candidate = asked(movement, line.character.entries[movement.name], line.timed, name)
    if not candidate.behavior.kept:
        return None
    behavior = replace(candidate.behavior, rule=None, reason=reason)
    candidate = with_hand(replace(candidate, behavior=behavior), kept, line.character.handedness)
    outcome = fitted(candidate, kept)
    return outcome if isinstance(outcome, FittedBehavior) else None
