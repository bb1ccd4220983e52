"""Whatever a schedule says, nothing jumps: behaviours of every kind and lexeme, at times that coincide, overlap, last
no time at all, or are at the very beginning and end."""

import dataclasses

from hypothesis import given
from hypothesis import strategies as st

from tests.support.examples import examples
from tests.support.motion.motion_limits import broken_limits
from understudy.model import Behavior, Channel, Hand, Interval, Level, Schedule, SyncPoints
from understudy.models import load_realizer
from understudy.realizer.head_and_gaze.gaze_targets import DIRECTIONS
from understudy.realizer.head_and_gaze.head import MOVEMENTS
from understudy.realizer.realizing import Realizer, realize
from understudy.realizer.scheduling.rests import POSTURES as HAND_POSTURES
from understudy.realizer.torso.posture import POSTURES

DURATION_S = 2.0
REALIZER: Realizer = load_realizer()
LEXEMES = {
    Channel.GESTURE: REALIZER.library.categories,
    Channel.HEAD: tuple(MOVEMENTS),
    Channel.GAZE: ("LOOK", "GLANCE", "SHIFT"),
    Channel.FACE: tuple(REALIZER.face.lexemes),
    Channel.EYES: ("BLINK",),
    Channel.POSTURE: (*POSTURES, *HAND_POSTURES),
}
ORDER: tuple[str, ...] = ("start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end")

TIMES_S = st.sampled_from([0.0, 0.05, 0.5, 1.0, 1.05, 1.5, 1.95, DURATION_S]) | st.floats(0.0, DURATION_S)


@st.composite
def behaviors(draw: st.DrawFn) -> Behavior:
    kind = draw(st.sampled_from(Channel))
    stroked = kind in (Channel.GESTURE, Channel.HEAD)
    names = ORDER if stroked else draw(st.sampled_from([("start", "end"), ("start", "ready", "relax", "end")]))
    times_s = sorted(draw(TIMES_S) for _ in names)
    return Behavior(
        id="",
        kind=kind,
        lexeme=draw(st.sampled_from(LEXEMES[kind])),
        sync=SyncPoints(**dict(zip(names, times_s, strict=True))),
        first=0,
        last=0,
        priority=float(draw(st.integers(0, 3))),
        hand=draw(st.none() | st.sampled_from(Hand)) if kind is Channel.GESTURE else None,
        amount=draw(st.sampled_from([None, 0.0, 0.3, 1.0])),
        target="listener" if kind is Channel.GAZE else None,
        direction=draw(st.none() | st.sampled_from(sorted(DIRECTIONS))) if kind is Channel.GAZE else None,
        repetitions=draw(st.none() | st.integers(1, 9)) if kind is Channel.HEAD else None,
        curved=draw(st.booleans()) if kind is Channel.GESTURE else False,
    )


@st.composite
def schedules(draw: st.DrawFn) -> Schedule:
    drawn = draw(st.lists(behaviors(), min_size=1, max_size=6))
    named = tuple(dataclasses.replace(each, id=f"behavior{number}") for number, each in enumerate(drawn))
    return Schedule(
        named,
        DURATION_S,
        phrases=draw(st.sampled_from([(), (Interval(0.1, 0.9), Interval(1.3, 1.9))])),
        emphases_s=tuple(sorted(draw(st.lists(TIMES_S, max_size=3)))),
        agitation=draw(st.sampled_from(Level)),
        stillness=draw(st.sampled_from([0.0, 0.0, 0.5, 1.0])),
    )


@examples(20)
@given(schedules(), st.integers(0, 3))
def test_nothing_jumps_whatever_is_asked_for(schedule: Schedule, seed: int) -> None:
    assert broken_limits(realize(REALIZER, schedule, seed=seed), REALIZER.skeleton) == []
