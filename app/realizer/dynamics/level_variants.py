"""Variants of gestures for low and high agitation (in paper §3.8 each gesture has its own recording for low, medium and
high).

In addition to scaling, calm hands stay lower, nearer to the body and relaxed; agitated hands go up and out, spread
(`variants` of lexicon/movement.yaml). A body that is female or male has them elsewhere at all three levels (`sexes`,
`MovementStyle.of`). Gestures that point or show a place, a height or a size are unchanged.
"""

from collections.abc import Mapping
from dataclasses import replace

from ...model import Level
from ..body.movement_style import LevelVariant, LevelVariants
from ..gestures.gesture import ArmKey, ClipKey, HandForm, HandShape
from ..gestures.gesture_plan import PlacedGesture

_OPEN = frozenset({HandForm.DEFAULT, HandForm.FLAT, HandForm.SPREAD})


def varied(placed: PlacedGesture, variants: Mapping[str, LevelVariants]) -> PlacedGesture:
    """The variant of the gesture for its level of agitation."""
    clip = placed.clip
    found = variants.get(clip.category)
    if found is None or placed.placed_by_words:
        return placed
    variant = {Level.LOW: found.low, Level.MEDIUM: found.medium, Level.HIGH: found.high}[clip.level]
    if not any(variant.offset_m) and not variant.hand:
        return placed
    return replace(placed, clip=replace(clip, keys=tuple(_varied_key(key, variant) for key in clip.keys)))


def _varied_key(key: ClipKey, variant: LevelVariant) -> ClipKey:
    return key.of(_varied_arm(key.left, variant), _varied_arm(key.right, variant))


def _varied_arm(arm: ArmKey | None, variant: LevelVariant) -> ArmKey | None:
    if arm is not None and arm.place is not None:
        out, up, away = (own + more for own, more in zip(arm.place.offset_m, variant.offset_m, strict=True))
        arm = arm.at(arm.place.offset_by((out, up, away)))
    if arm is not None and arm.hand is not None and variant.hand and arm.hand.form in _OPEN and not arm.fingers:
        arm = replace(arm, hand=HandShape(HandForm(variant.hand)))
    return arm
