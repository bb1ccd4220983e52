"""Hand-made clips and schedules of gestures, with places and times that can be reckoned in the head."""

from collections.abc import Mapping
from dataclasses import dataclass

from understudy.model import Behavior, Channel, Hand, Level, SyncPoints
from understudy.realizer.gestures.gesture import (
    ArmKey,
    Clip,
    ClipKey,
    Depth,
    Expressivity,
    FrameType,
    HeightSector,
    Markers,
    SectorPlace,
    Sideways,
)
from understudy.realizer.gestures.gesture_plan import arms_of

MARKERS = Markers(start=0.0, ready=0.4, stroke_start=0.5, stroke=0.8, stroke_end=1.0, relax=1.2, end=1.6)
"""Of every clip that says nothing else: .3 s from stroke start to stroke, .4 s from stroke to relax."""


def place(outwards_m: float = 0.0, up_m: float = 0.0) -> SectorPlace:
    """So far from the middle of gesture space."""
    return SectorPlace(Sideways.C, HeightSector.CC, Depth.MIDDLE, (outwards_m, up_m, 0.0))


@dataclass(frozen=True, slots=True)
class HandMade:
    """A library that has exactly these clips, by category."""

    by_category: Mapping[str, tuple[Clip, ...]]

    def clips(self, category: str, level: Level, hand: Hand) -> tuple[Clip, ...]:
        return tuple(each for each in self.by_category[category] if each.hand is hand and each.level is level)

    def nearest(self, lexeme: str) -> str | None:
        return next((each for each in (lexeme, "BEAT") if each in self.by_category), None)


def library(*clips: Clip) -> HandMade:
    return HandMade({each.category: tuple(one for one in clips if one.category == each.category) for each in clips})


def clip(
    name: str = "wave",
    *,
    category: str = "GREETING",
    hand: Hand = Hand.RIGHT,
    markers: Markers = MARKERS,
    from_m: float = 0.0,
    to_m: float = 0.3,
    expressivity: Expressivity | None = None,
) -> Clip:
    """A stroke outwards, from `from_m` to `to_m`; its speed is the way by the time."""
    keys = (
        (markers.stroke_start, FrameType.STROKE_START, from_m),
        (markers.stroke_end, FrameType.STROKE_END, to_m),
    )
    arms = arms_of(hand)
    return Clip(
        name=name,
        category=category,
        level=Level.MEDIUM,
        hand=hand,
        markers=markers,
        keys=tuple(_key(time_s, kind, ArmKey(place=place(out_m)), arms) for time_s, kind, out_m in keys),
        expressivity=expressivity or Expressivity(),
        stroke_speed_m_s=abs(to_m - from_m) / (markers.stroke_end - markers.stroke_start),
    )


def _key(time_s: float, kind: FrameType, key: ArmKey, arms: tuple[Hand, ...]) -> ClipKey:
    return ClipKey(time_s, kind, key if Hand.LEFT in arms else None, key if Hand.RIGHT in arms else None)


def gesture(
    name: str,
    stroke_s: float,
    relax_s: float,
    *,
    lexeme: str = "GREETING",
    hand: Hand = Hand.RIGHT,
    priority: float = 5.0,
    amount: float | None = None,
    stroke_end_s: float | None = None,
) -> Behavior:
    """A kept gesture with the phases that our schedules give theirs."""
    sync = SyncPoints(
        start=max(0.0, stroke_s - 0.75),
        ready=max(0.0, stroke_s - 0.3),
        stroke_start=max(0.0, stroke_s - 0.3),
        stroke=stroke_s,
        stroke_end=min(stroke_s + 0.2, relax_s) if stroke_end_s is None else stroke_end_s,
        relax=relax_s,
        end=relax_s + 0.5,
    )
    return Behavior(name, Channel.GESTURE, lexeme, sync, 0, 0, priority, hand=hand, amount=amount)
