"""What the other hand does: it follows a gesture of one hand, and in one of both it is no mirror image of the first.

A hand that follows goes part of the way from hanging to the gesture's mirror image, a little later, relaxed. Where it
does not follow it stays where hands rest, unless that takes two hands: a hand that was clasped with the one that
gestures hangs. In two-handed gestures the hand that does not lead comes later and makes less (lexicon/movement.yaml).

What is drawn for a gesture depends on the seed and on the gesture alone, so that editing one leaves the others.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...model import Hand, Level
from ..arms.rest_poses import HANGING, LAPS, resting
from ..arms.wrist_paths import stroke_end_m
from ..body.movement_style import MovementStyle
from ..gestures.gesture import Clip, ClipKey
from ..gestures.gesture_plan import PlacedGesture, drawn
from .arm_timelines import pose_at
from .rests import AT_SIDE, RestChange
from .transitions import transition_s

OTHER = {Hand.LEFT: Hand.RIGHT, Hand.RIGHT: Hand.LEFT}
BENDS = (-0.3, 1.0)
"""By how much fingers are bent differently, as shares of the style's: rather more than less, to stay within limits."""
_HIGHEST_FOLLOWED_M = 0.6
"""How high above the hips, about the shoulders' height, a hand may be that the other one follows as far as it would."""
_LOW_M = 0.06
"""A hand that goes lower than this shows something below: the other one does not stay above it."""
FREE_S = 0.3
"""What a lag leaves of the time to the arm's next stroke."""


@dataclass(frozen=True, slots=True)
class HandHabits:
    """Which hand leads, how the other one goes along, and the seed of what is drawn."""

    leading: Hand
    style: MovementStyle
    seed: int

    def drawn(self, gesture: PlacedGesture) -> np.random.Generator:
        return drawn(self.seed, gesture)


def led_by(gesture: PlacedGesture, leading: Hand) -> PlacedGesture:
    """A two-handed gesture whose leading part, the right hand's in the library, is made by `leading`."""
    if gesture.clip.hand is not Hand.BOTH or leading is Hand.RIGHT:
        return gesture
    keys = tuple(replace(key, left=key.right, right=key.left) for key in gesture.clip.keys)
    return replace(gesture, clip=replace(gesture.clip, keys=keys))


def of_arm(
    side: Hand, gestures: Sequence[PlacedGesture], changes: tuple[RestChange, ...], habits: HandHabits
) -> tuple[PlacedGesture, ...]:
    """What an arm makes of the gestures of both, in order: its own, later ones where it does not lead, and those in
    which it only goes along."""
    own = [each for each in gestures if side in each.arms]
    made = [_trailing(each, own, side, habits) for each in own]
    followed = (_following(each, side, made, changes, habits) for each in gestures if side not in each.arms)
    return tuple(sorted([*made, *(each for each in followed if each)], key=lambda each: each.stroke_start_s))


def _trailing(gesture: PlacedGesture, own: Iterable[PlacedGesture], side: Hand, habits: HandHabits) -> PlacedGesture:
    if gesture.clip.hand is not Hand.BOTH or side is habits.leading:
        return gesture
    rng, two = habits.drawn(gesture), habits.style.two_hands
    lag_s, smaller = float(rng.uniform(*two.lag_s)), float(rng.uniform(*two.smaller))
    smaller = 0.0 if _is_measured(gesture) else smaller
    bends_deg = tuple(float(bend) for bend in two.bend_deg * rng.uniform(*BENDS, size=4))
    later = min((each.stroke_start_s for each in own if each.stroke_start_s > gesture.stroke_start_s), default=np.inf)
    room_s = max(0.0, later - gesture.stroke_end_s - FREE_S)
    return _later(replace(gesture, bends_deg=bends_deg), min(lag_s, room_s), size=1 - smaller)


def _is_measured(gesture: PlacedGesture) -> bool:
    """Whether both hands together show a size."""
    return gesture.request.slots is not None and gesture.request.slots.size_m is not None


def _following(
    gesture: PlacedGesture,
    side: Hand,
    own: Iterable[PlacedGesture],
    changes: tuple[RestChange, ...],
    habits: HandHabits,
) -> PlacedGesture | None:
    """How the arm goes along with a gesture of the other; None if it rests or has to be elsewhere."""
    second, pose = habits.style.second_hand, pose_at(changes, max(0.0, gesture.stroke_start_s))
    rest = resting(pose, side)
    if not second.follows or not (rest is HANGING or rest.ready_at or rest.holds):
        return None
    rng = habits.drawn(gesture)
    lag_s, share = float(rng.uniform(*second.lag_s)), float(rng.uniform(*second.share))
    follows = bool(rng.uniform() < second.follows)
    if not rest.holds and not follows:
        return None
    clip = _of_other_hand(gesture.clip, side)
    basis = pose if rest.ready_at else LAPS[Level.LOW] if second.near_belly and follows else AT_SIDE
    share *= _below_the_chest(gesture)
    if float(stroke_end_m(gesture, gesture.clip.hand)[1]) < _LOW_M:
        basis = AT_SIDE
    made = _later(replace(gesture, clip=clip, aim_m=None, share=share if follows else 0.0, basis=basis), lag_s)
    return _between(made, list(own))


def _below_the_chest(gesture: PlacedGesture) -> float:
    """The factor of the way that an arm goes along with a hand that is raised: its own hand stays low, or its elbow
    would wing out at the shoulder's height with a forearm that shows nothing."""
    raised_m = float(stroke_end_m(gesture, gesture.clip.hand)[1])
    return min(1.0, _HIGHEST_FOLLOWED_M / max(raised_m, _HIGHEST_FOLLOWED_M))


def _between(made: PlacedGesture, own: Sequence[PlacedGesture]) -> PlacedGesture | None:
    """The gesture with its hold cut where the arm's own next one needs the time; None if there is no time for it."""
    before = [each for each in own if each.stroke_start_s <= made.stroke_start_s]
    after = [each for each in own if each.stroke_start_s > made.stroke_start_s]
    if before and made.stroke_start_s - before[-1].relax_s < transition_s(before[-1], made, made.clip.hand):
        return None
    if not after:
        return made
    until_s = after[0].stroke_start_s - transition_s(made, after[0], made.clip.hand)
    repeats = tuple(each for each in made.repeats if each.end_s <= until_s)
    cut = replace(made, relax_s=min(made.relax_s, until_s), repeats=repeats)
    return cut if until_s >= made.stroke_end_s else None


def _later(gesture: PlacedGesture, lag_s: float, *, size: float = 1.0) -> PlacedGesture:
    """The gesture with its stroke and what follows `lag_s` later; a hold absorbs the lag."""
    request = replace(gesture.request, stroke_s=gesture.request.stroke_s + lag_s, size=size * gesture.request.size)
    repeats = tuple(replace(each, start_s=each.start_s + lag_s, end_s=each.end_s + lag_s) for each in gesture.repeats)
    relax_s = max([gesture.relax_s, gesture.stroke_end_s + lag_s, *(each.end_s for each in repeats)])
    return replace(gesture, request=request, repeats=repeats, relax_s=relax_s)


def _of_other_hand(clip: Clip, side: Hand) -> Clip:
    return replace(clip, hand=side, keys=tuple(_mirrored(clip.keys)))


def _mirrored(keys: Iterable[ClipKey]) -> Iterator[ClipKey]:
    """Keys are relative to their own arm, so the mirror image is the same key on the other side."""
    return (replace(key, left=key.right, right=key.left) for key in keys)
