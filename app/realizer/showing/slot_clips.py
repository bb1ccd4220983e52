"""Plays the slots of a schedule's gestures: which gesture shows them, and its clip with what they say.

A gesture that was chosen to show a height shows it with one palm, a size with two or with two fingers, a number with as
many fingers, a place by pointing there (docs/slots.md). What a lexeme shows otherwise than the library has it is told
as a decision.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from math import atan2, degrees
from types import MappingProxyType

from ...model import Hand
from ...model.slots import Distance, Slots, Which
from ..arms.wrist_paths import amplitude, stroke_end_m
from ..body.motion import Decision
from ..gestures.gesture import Clip, HandForm
from ..gestures.gesture_plan import GestureRequest, PlacedGesture, Position
from .directions import POINTING, points_far, told
from .measures import TINY_M, begun_in_time, counting, measuring, placed_aside, stretched
from .sectors import led, led_decisions

NUMBERS = ("COUNT_ONE", "COUNT_TWO", "COUNT_THREE", "COUNT_FOUR", "COUNT_FIVE")
COUNTING = frozenset({"COUNT", "COUNT_FIRST", "COUNT_NEXT", *NUMBERS})
PLACES = MappingProxyType(
    {
        "HERE": "THERE",
        "UP": "THERE",
        "DOWN": "THERE",
        "POINT_UP": "THERE",
        "CENTER": "THERE",
        "LEFT": "POINT_LEFT",
        "RIGHT": "POINT_RIGHT",
    }
)
"""What shows a place, where the words say what or where it is, by the gesture that points at it."""

_MOMENT_S = 0.001
_HIGH_M = 1.25
"""Above the elbow, where a palm that shows a height comes from below."""
_ACROSS_DEG = 15.0
_HARDLY_FARTHER = 1.2
_LONG_M = 0.4
"""From here on a size is shown by hands that part, below by hands that meet."""


def category_shown(request: GestureRequest, leading: Hand = Hand.RIGHT) -> tuple[str, Hand]:
    """The category of gestures, and the hand, that show the slots of a request: its own where they say nothing that
    another would show better. Both hands show a size, where the words say one besides a height; what takes one hand is
    shown by the `leading` one instead of both."""
    slots, lexeme, hand = request.slots or Slots(), request.category, request.hand
    both_sized = hand is Hand.BOTH and slots.size_m is not None
    one_hand = leading if hand is Hand.BOTH else hand
    if slots.height_m is not None and not both_sized:
        return ("HEIGHT_HIGH" if slots.height_m > _HIGH_M else "HEIGHT_LOW"), one_hand
    if slots.size_m is not None:
        return _sized(slots.size_m, lexeme, hand)
    if slots.count is not None and lexeme in COUNTING:
        return (NUMBERS[slots.count - 1], one_hand) if slots.count <= len(NUMBERS) else (NUMBERS[-1], Hand.BOTH)
    if lexeme in PLACES and request.target is None and _is_somewhere(lexeme, slots):
        return PLACES[lexeme], one_hand
    return lexeme, hand


def _is_somewhere(lexeme: str, slots: Slots) -> bool:
    """Whether the words name a thing, or say both how far away and how high something is: "up there". What is in the
    middle is elsewhere only where they say that it is far, or "that" one; a finger that is raised shows no place unless
    they do."""
    if lexeme == "CENTER" and slots.distance is not Distance.FAR and slots.which is not Which.THAT:
        return False
    if lexeme == "POINT_UP" and not slots.distance and not slots.which and slots.elevation_deg is None:
        return False
    return slots.referent is not None or (slots.distance is not None and slots.elevation_deg is not None)


def _sized(size_m: float, lexeme: str, hand: Hand) -> tuple[str, Hand]:
    if hand is Hand.BOTH:
        return ("WIDE" if size_m >= _LONG_M else "NARROW"), hand
    return ("PINCH" if size_m <= TINY_M else lexeme), hand


def as_shown(
    request: GestureRequest, nearest: Callable[[str], str | None], leading: Hand = Hand.RIGHT
) -> GestureRequest:
    """The request for the gesture that shows its slots, by the character's `leading` hand where it takes one; `nearest`
    is the category that shows a lexeme, if any."""
    category, hand = category_shown(request, leading)
    as_it_is = (category, hand) == (request.category, request.hand) or nearest(category) != category
    return request if as_it_is else replace(request, category=category, hand=hand)


def showing(placed: PlacedGesture, aims_m: Mapping[str, Position]) -> PlacedGesture:
    """The gesture with the height, size, number or place that its slots say, or with the places of its script. What is
    measured, pointed at or put somewhere is as big as the words have it, in any voice: from how far the hand comes is
    the voice's."""
    request = placed.request
    slots = request.slots
    if slots is None:
        return led(placed)
    clip = measuring(placed.clip, slots)
    if clip is not placed.clip:
        return _coming(replace(placed, clip=clip, request=replace(request, size=1.0, scale=1.0)))
    if slots.count is not None and clip.category in COUNTING:
        return replace(placed, clip=counting(clip, slots.count))
    aim_m = aims_m.get(request.behavior)
    if aim_m is not None and clip.aimed:
        return _pointing(_in_usual_size(placed), slots, aim_m)
    if slots.side is not None and clip.hand is not Hand.BOTH and not clip.aimed:
        usual = _in_usual_size(placed)
        return replace(usual, clip=placed_aside(clip, slots.side, amplitude(usual), request.manner))
    return placed


def in_its_place(placed: PlacedGesture) -> PlacedGesture:
    """A gesture at the body in its usual size, so that the hand is at the chest or the temple in any voice: from how
    far it comes is the voice's."""
    if not placed.clip.at_the_body or placed.request.manner.amplitude == 1.0:
        return placed
    usual = _in_usual_size(placed)
    ends_m = {side: stroke_end_m(usual, side) for side in usual.arms}
    return replace(usual, clip=begun_in_time(usual.clip, ends_m, amplitude(usual), placed.request.manner))


def _in_usual_size(placed: PlacedGesture) -> PlacedGesture:
    """The gesture as big as it is in a usual voice."""
    request = placed.request
    return replace(placed, request=replace(request, size=request.size / request.manner.amplitude))


def _coming(placed: PlacedGesture) -> PlacedGesture:
    """The gesture that measures something, with hands that come from as far as the voice has it; two hands hardly
    farther than usual, for those that open wide before show something wide."""
    manner, size = placed.request.manner, amplitude(placed)
    if placed.clip.hand is Hand.BOTH:
        manner = replace(manner, amplitude=min(manner.amplitude, _HARDLY_FARTHER))
    ends_m = {side: stroke_end_m(placed, side) for side in placed.arms}
    return replace(placed, clip=begun_in_time(placed.clip, ends_m, size, manner))


def _pointing(placed: PlacedGesture, slots: Slots, aim_m: Position) -> PlacedGesture:
    """The gesture whose hand goes out from before the body to the line on which it points, as far from there as it has
    time for."""
    far = points_far(slots) or _is_across(placed, aim_m)
    clip = stretched(placed.clip, amplitude(placed)) if far else placed.clip
    aimed = replace(placed, clip=clip, aim_m=aim_m, aimed_from_s=clip.markers.stroke_start + _MOMENT_S)
    ends_m = {side: stroke_end_m(aimed, side) for side in aimed.arms}
    return replace(aimed, clip=begun_in_time(clip, ends_m, amplitude(placed), placed.request.manner))


def _is_across(placed: PlacedGesture, aim_m: Position) -> bool:
    """Whether a hand points to the other side of the body, where a bent arm lies before the chest and shows nothing."""
    to_the_left_deg = degrees(atan2(aim_m[0], aim_m[2]))
    return abs(to_the_left_deg) > _ACROSS_DEG and (to_the_left_deg > 0) is (placed.clip.hand is Hand.RIGHT)


def finger_first(clips: tuple[Clip, ...], request: GestureRequest) -> tuple[Clip, ...]:
    """The clips in order, of pointings at what is far those with the index finger first."""
    if request.slots is None or request.category not in POINTING or not points_far(request.slots):
        return clips
    return tuple(sorted(clips, key=lambda clip: not _has_index(clip)))


def _has_index(clip: Clip) -> bool:
    arms = (arm for key in clip.keys for arm in (key.left, key.right) if arm is not None and arm.hand is not None)
    return any(arm.hand is not None and arm.hand.form is HandForm.INDEX for arm in arms)


def shown_decisions(asked: GestureRequest, placed: PlacedGesture) -> Iterator[Decision]:
    """What a gesture shows that its lexeme alone would not, and what of its places it cannot."""
    yield from (Decision(asked.behavior, "placed", told) for told in led_decisions(asked.way, placed))
    slots = asked.slots
    if slots is None:
        return
    said = [*_measured(slots, placed), *(told(slots) if placed.aim_m is not None else ())]
    if said:
        yield Decision(asked.behavior, "shown", f"{asked.category} shows {', '.join(said)}, by {placed.clip.name}")


def _measured(slots: Slots, placed: PlacedGesture) -> Iterator[str]:
    if placed.clip.category.startswith("HEIGHT") and slots.height_m is not None:
        yield f"a height of {slots.height_m:g} m"
    elif placed.clip.category in ("WIDE", "NARROW", "PINCH") and slots.size_m is not None:
        yield f"a size of {slots.size_m:g} m"
    elif placed.clip.category in COUNTING and slots.count is not None:
        yield f"the number {slots.count}"
