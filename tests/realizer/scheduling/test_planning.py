"""The scheduler of §3.8, rule by rule, with clips whose times and places can be reckoned in the head."""

from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.motion.gesture_clips import MARKERS, HandMade, clip, gesture, library
from understudy.model import Behavior, Channel, Hand, Interval, Schedule, SyncPoints
from understudy.model.limits import LATEST_S
from understudy.realizer.arms.wrist_paths import distance_m, stroke_start_m
from understudy.realizer.gestures.gesture import Expressivity, Markers
from understudy.realizer.gestures.gesture_plan import GesturePlan
from understudy.realizer.scheduling.planning import plan_gestures
from understudy.realizer.scheduling.rests import TOP_SPEED_M_S, rest_m


def planned(
    behaviors: list[Behavior],
    clips: HandMade | None = None,
    *,
    phrases: tuple[Interval, ...] = (),
    emphases_s: tuple[float, ...] = (),
) -> GesturePlan:
    """The plan for a line that goes on for 4 s after its last gesture."""
    duration_s = max((each.sync.end for each in behaviors), default=0.0) + 4.0
    schedule = Schedule(tuple(behaviors), duration_s, phrases=phrases, emphases_s=emphases_s)
    return plan_gestures(clips or library(clip()), schedule, seed=0)


def actions(plan: GesturePlan, behavior: str) -> list[str]:
    return [each.action for each in plan.decisions if each.behavior == behavior]


def test_the_stroke_is_aligned_and_the_hold_extended_to_the_desired_relax_time() -> None:
    plan = planned([gesture("g1", 2.0, 3.1)])
    (arm,) = plan.gestures
    assert arm.markers.stroke == 2.0
    assert arm.markers.stroke_start == pytest.approx(1.7)
    assert arm.markers.stroke_end == pytest.approx(2.2)
    assert arm.markers.relax == 3.1
    assert arm.markers.end > 3.1
    assert plan.decisions == ()


@pytest.mark.parametrize(
    ("relax_s", "kept", "action"),
    [
        (2.40, True, []),
        (2.31, True, []),
        (2.29, True, ["shortened"]),
        (2.11, True, ["shortened"]),
        (2.09, False, ["dropped"]),
    ],
)
def test_a_clip_longer_than_stroke_to_relax_does_not_fit(relax_s: float, kept: bool, action: list[str]) -> None:
    """Eq. 5: the clip has .4 s to relax, .2 s without its hold, and .1 s is forgiven."""
    asked = gesture("g1", 2.0, relax_s)
    plan = planned([replace(asked, sync=replace(asked.sync, stroke_end=None))])
    assert bool(plan.gestures) is kept
    if relax_s != 2.31:
        assert actions(plan, "g1") == action


def test_a_stroke_for_which_the_schedule_has_half_the_time_is_brief() -> None:
    """The clip's takes .5 s, of which .3 s before the emphasis."""
    asked = gesture("g1", 2.0, 3.0)
    hurried = replace(asked, sync=replace(asked.sync, stroke_start=1.85, stroke_end=2.1))
    (arm,) = planned([hurried]).gestures
    assert (arm.markers.stroke_start, arm.markers.stroke, arm.markers.stroke_end) == pytest.approx((1.85, 2.0, 2.1))
    barely = replace(asked, sync=replace(asked.sync, stroke_start=1.75, stroke_end=2.17))
    (arm,) = planned([barely]).gestures
    assert arm.markers.stroke_start == pytest.approx(1.7)


def test_of_clips_only_one_that_fits_is_taken() -> None:
    long = replace(MARKERS, stroke_end=1.6, relax=1.8, end=2.2)
    clips = library(clip("long", markers=long), clip("short"))
    for seed in range(10):
        plan = plan_gestures(clips, Schedule((gesture("g1", 2.0, 2.4),), 4.0), seed=seed)
        assert [arm.placed.clip.name for arm in plan.gestures] == ["short"]


def test_variants_are_drawn_by_seed_and_the_one_used_last_waits() -> None:
    clips = library(clip("one"), clip("two"))
    behaviors = tuple(gesture(f"g{n}", 2.0 + 4 * n, 2.5 + 4 * n) for n in range(6))
    firsts = set()
    for seed in range(12):
        names = [arm.placed.clip.name for arm in plan_gestures(clips, Schedule(behaviors, 30.0), seed=seed).gestures]
        assert all(before != after for before, after in pairwise(names))
        firsts.add(names[0])
    assert firsts == {"one", "two"}


@pytest.mark.parametrize(("first", "second", "stays"), [(5.0, 4.0, "g1"), (4.0, 5.0, "g2"), (5.0, 5.0, "g1")])
def test_a_stroke_that_starts_before_the_neighbour_relaxes_costs_the_less_important(
    first: float, second: float, stays: str
) -> None:
    """The second stroke starts at 2.9 - .3 = 2.6 s, before 2.7 s."""
    plan = planned([gesture("g1", 2.0, 2.7, priority=first), gesture("g2", 2.9, 3.4, priority=second)])
    assert [arm.behavior for arm in plan.gestures] == [stays]
    (loser,) = {"g1", "g2"} - {stays}
    assert actions(plan, loser) == ["dropped"]
    assert "start at 2.60 s, before g1 relaxes at 2.70 s" in plan.decisions[0].reason


def test_what_made_way_for_a_gesture_makes_room_for_the_one_before_it() -> None:
    """g3 overlaps g2 and drops it; g1 and g3 are far enough apart."""
    behaviors = [gesture("g1", 2.0, 2.5, priority=9), gesture("g2", 3.2, 4.0, priority=1), gesture("g3", 4.1, 4.6)]
    plan = planned(behaviors)
    assert [arm.behavior for arm in plan.gestures] == ["g1", "g3"]
    assert plan.gestures[1].blended_from == "g1"


def test_neighbours_blend_from_relax_to_stroke_start_without_rest() -> None:
    """.3 m back in .5 s is .6 m/s, which is the stroke's own speed: nothing to hold, nothing too fast."""
    plan = planned([gesture("g1", 2.0, 2.5), gesture("g2", 3.3, 3.8)])
    first, second = plan.gestures
    assert (first.blended_to, second.blended_from) == ("g2", "g1")
    assert first.markers.relax == first.markers.end == second.markers.start == pytest.approx(2.5)
    assert second.markers.ready == second.markers.stroke_start == pytest.approx(3.0)
    assert [rest.pose for rest in plan.rests if rest.side is Hand.RIGHT and 2.5 <= rest.start_s < 3.0] == []
    (transition,) = plan.transitions
    assert transition.speed_m_s == pytest.approx(0.6)
    assert actions(plan, "g2") == ["blended"]
    assert actions(plan, "g1") == []


def test_a_slow_way_prolongs_the_hold_until_the_speeds_match() -> None:
    """Figure 4: .3 m in 1.2 s is slower than .6 m/s; t_h = 1.2 - .3 / .6 = .7 s."""
    plan = planned([gesture("g1", 2.0, 2.5), gesture("g2", 4.0, 4.5)])
    first, second = plan.gestures
    assert second.markers.stroke_start - 2.5 == pytest.approx(1.2)
    assert first.markers.relax == pytest.approx(2.5 + 0.7)
    assert plan.transitions[0].speed_m_s == pytest.approx(0.6)
    assert plan.realized["g1"].relax == pytest.approx(3.2)
    assert actions(plan, "g1") == ["held"]


@pytest.mark.parametrize(("first", "second", "stays"), [(5.0, 4.0, "g1"), (4.0, 5.0, "g2")])
def test_a_way_too_fast_to_blend_costs_the_less_important(first: float, second: float, stays: str) -> None:
    """.3 m back in .2 s is 1.5 m/s, .9 above the stroke's .6, and v_th is .5 m/s."""
    plan = planned([gesture("g1", 2.0, 2.5, priority=first), gesture("g2", 3.0, 3.5, priority=second)])
    assert [arm.behavior for arm in plan.gestures] == [stays]
    assert "needs 0.27 s for the 30 cm" in plan.decisions[0].reason


def test_a_way_within_the_threshold_is_played() -> None:
    """.3 m in .3 s is 1.0 m/s, .4 above the stroke's .6."""
    plan = planned([gesture("g1", 2.0, 2.5), gesture("g2", 3.1, 3.6)])
    assert [arm.behavior for arm in plan.gestures] == ["g1", "g2"]


def test_a_clip_of_the_category_that_is_near_enough_replaces_one_that_is_not() -> None:
    clips = library(clip(category="FIRST"), clip("far", from_m=-0.3, to_m=0.0), clip("near", from_m=0.3, to_m=0.0))
    behaviors = (gesture("g1", 2.0, 2.5, lexeme="FIRST"), gesture("g2", 3.0, 3.5))
    replaced = 0
    for seed in range(10):
        plan = plan_gestures(clips, Schedule(behaviors, 5.0), seed=seed)
        assert [arm.placed.clip.name for arm in plan.gestures] == ["wave", "near"]
        replaced += "replaced" in actions(plan, "g2")
    assert 0 < replaced < 10


def test_each_hand_has_its_own_neighbours() -> None:
    """The stroke of the left hand starts while the right one strikes: no conflict. Both hands would be one."""
    right, left = clip(), clip("left", hand=Hand.LEFT)
    both = clip("both", hand=Hand.BOTH)
    apart = [gesture("g1", 2.0, 2.7), gesture("g2", 2.5, 3.0, hand=Hand.LEFT)]
    assert {arm.behavior for arm in planned(apart, library(right, left)).gestures} == {"g1", "g2"}
    together = [gesture("g1", 2.0, 2.7), gesture("g2", 2.5, 3.0, hand=Hand.BOTH)]
    assert {arm.behavior for arm in planned(together, library(right, both)).gestures} == {"g1"}


def test_a_gesture_of_both_hands_blends_on_one_arm_and_starts_from_rest_on_the_other() -> None:
    clips = library(clip(), clip("both", hand=Hand.BOTH))
    plan = planned([gesture("g1", 2.0, 2.5), gesture("g2", 3.3, 3.8, hand=Hand.BOTH)], clips)
    arms = {arm.side: arm for arm in plan.gestures if arm.behavior == "g2"}
    assert (arms[Hand.RIGHT].blended_from, arms[Hand.LEFT].blended_from) == ("g1", None)
    assert arms[Hand.LEFT].markers.stroke == arms[Hand.RIGHT].markers.stroke == 3.3
    assert arms[Hand.LEFT].markers.start < arms[Hand.LEFT].markers.stroke_start


def test_neighbours_of_different_phrases_rest_between_them_when_there_is_time() -> None:
    """1.48 s from relax to stroke start: in one phrase they flow together, in two the hand goes to rest."""
    behaviors = [gesture("g1", 2.0, 2.5), gesture("g2", 4.28, 4.7)]
    near = library(clip(from_m=-0.1, to_m=0.1))
    one = planned(behaviors, near, phrases=(Interval(0.0, 5.0),))
    two = planned(behaviors, near, phrases=(Interval(0.0, 3.0), Interval(3.2, 5.0)))
    assert [unit.behaviors for unit in one.units] == [("g1", "g2")]
    assert [unit.behaviors for unit in two.units] == [("g1",), ("g2",)]
    assert two.transitions == ()


def test_neighbours_of_different_phrases_with_no_time_to_rest_blend() -> None:
    behaviors = [gesture("g1", 2.0, 2.5), gesture("g2", 3.3, 3.8)]
    plan = planned(behaviors, phrases=(Interval(0.0, 2.6), Interval(2.8, 5.0)))
    assert plan.gestures[1].blended_from == "g1"


@pytest.mark.parametrize(("gap_s", "pose"), [(2.0, "clasped"), (6.0, "at_side"), (12.0, "in_pockets")])
def test_the_way_to_rest_is_chosen_by_the_distance_to_the_next_unit(gap_s: float, pose: str) -> None:
    """From the relax time at 2.5 s to the next stroke start, .3 s before the stroke."""
    stroke_s = 2.5 + gap_s + 0.3
    clips = library(clip(), clip("both", hand=Hand.BOTH))
    behaviors = [gesture("g1", 2.0, 2.5, hand=Hand.BOTH), gesture("g2", stroke_s, stroke_s + 0.5)]
    plan = planned(behaviors, clips)
    resting = [rest.pose for rest in plan.rests if rest.side is Hand.RIGHT and 2.5 < rest.start_s < stroke_s]
    assert resting == [pose]


def test_one_hand_is_not_clasped_with_one_that_has_not_moved() -> None:
    plan = planned([gesture("g1", 2.0, 2.5), gesture("g2", 5.0, 5.5)])
    assert {rest.pose for rest in plan.rests} == {"at_side"}


def test_both_arms_rest_alike_and_after_the_last_unit_at_the_sides() -> None:
    clips = library(clip("both", hand=Hand.BOTH))
    plan = planned([gesture("g1", 2.0, 2.5, hand=Hand.BOTH), gesture("g2", 5.0, 5.5, hand=Hand.BOTH)], clips)
    for side in (Hand.LEFT, Hand.RIGHT):
        rests = [rest for rest in plan.rests if rest.side is side]
        assert rests[0].start_s == 0.0
        assert rests[-1].pose == "at_side"
        assert rests[-1].end_s == plan.end_s
        assert {rest.pose for rest in rests[:-1]} == {"clasped"}


def test_a_hand_goes_straight_to_the_rest_that_follows_soon() -> None:
    """Both hands, then the right one alone: the left goes down when its own gesture is over, and stays there."""
    clips = library(clip(), clip("both", hand=Hand.BOTH))
    plan = planned([gesture("g1", 2.0, 2.5, hand=Hand.BOTH), gesture("g2", 3.3, 3.8)], clips)
    assert [rest.pose for rest in plan.rests if rest.side is Hand.LEFT] == ["clasped", "at_side"]


def test_a_posture_says_how_the_hands_rest_from_then_on() -> None:
    folded = Behavior("p1", Channel.POSTURE, "HANDS_FOLDED", SyncPoints(5.0, 5.7, ready=5.7), 0, 0, 1.0)
    plan = planned([gesture("g1", 2.0, 2.5), folded, gesture("g2", 8.0, 8.5)])
    assert [rest.pose for rest in plan.rests if rest.side is Hand.RIGHT] == ["at_side", "at_side", "folded", "folded"]


@pytest.mark.parametrize(("stroke_s", "late_s"), [(0.25, 0.05), (0.0, 0.3)])
def test_a_first_stroke_that_would_start_before_the_first_frame_starts_with_it(stroke_s: float, late_s: float) -> None:
    """The clip's stroke takes .3 s to its emphasis."""
    plan = planned([gesture("g1", stroke_s, 0.8)])
    (arm,) = plan.gestures
    assert (arm.markers.start, arm.markers.stroke_start, arm.initial_progress) == (0.0, 0.0, 1.0)
    assert plan.realized["g1"].stroke == pytest.approx(stroke_s + late_s)
    assert actions(plan, "g1")[0] == "late"


def test_a_first_preparation_is_shortened_rather_than_begun_before_the_first_frame() -> None:
    """.36 s to the stroke start, and the clip's preparation takes .4 s."""
    plan = planned([gesture("g1", 0.66, 1.1)])
    (arm,) = plan.gestures
    assert arm.markers.start == 0.0
    assert arm.initial_progress == 0.0
    assert actions(plan, "g1") == ["shortened"]


def test_a_hand_too_far_for_the_time_that_is_left_is_raised_in_the_first_frame() -> None:
    """.1 s to the stroke start; the way at the top speed takes longer."""
    (arm,) = planned([gesture("g1", 0.4, 0.9)]).gestures
    way_m = distance_m(rest_m("at_side", Hand.RIGHT), stroke_start_m(arm.placed, Hand.RIGHT))
    assert arm.initial_progress == pytest.approx(1 - 0.1 / (way_m / TOP_SPEED_M_S))


def test_beats_are_repeated_on_further_emphases_each_smaller() -> None:
    beat = gesture("g1", 2.0, 2.5, lexeme="BEAT")
    clips = library(clip("beat", category="BEAT"))
    plan = planned([beat], clips, emphases_s=(2.2, 2.4, 2.8, 3.5, 4.2))
    (arm,) = plan.gestures
    assert [(repeat.end_s, repeat.amplitude) for repeat in arm.placed.repeats] == [(2.8, 0.6), (3.5, 0.4)]
    assert arm.markers.relax == pytest.approx(3.6)
    assert actions(plan, "g1") == ["repeated"]


def test_a_gesture_is_repeated_as_often_as_its_expressivity_says_and_its_phrase_lasts() -> None:
    lively = clip(expressivity=Expressivity(repetition=1.0))
    emphases_s = (2.8, 3.5, 4.2, 4.9)
    behaviors = [gesture("g1", 2.0, 2.5)]
    whole = planned(behaviors, library(lively), emphases_s=emphases_s)
    assert [repeat.end_s for repeat in whole.gestures[0].placed.repeats] == [2.8, 3.5, 4.2]
    short = planned(behaviors, library(lively), emphases_s=emphases_s, phrases=(Interval(0.0, 3.6),))
    assert [repeat.end_s for repeat in short.gestures[0].placed.repeats] == [2.8, 3.5]
    assert planned(behaviors, emphases_s=emphases_s).gestures[0].placed.repeats == ()


def test_repetitions_end_before_the_hand_must_leave_for_the_next_gesture() -> None:
    """The next stroke starts at 3.7 s and is .5 s away at its own speed."""
    clips = library(clip("beat", category="BEAT"), clip())
    behaviors = [gesture("g1", 2.0, 2.5, lexeme="BEAT"), gesture("g2", 4.0, 4.5)]
    plan = planned(behaviors, clips, emphases_s=(2.8, 3.3))
    assert [repeat.end_s for repeat in plan.gestures[0].placed.repeats] == [2.8]
    assert plan.gestures[0].markers.relax == pytest.approx(3.2)


def test_an_unknown_category_is_shown_by_a_beat() -> None:
    plan = planned([gesture("g1", 2.0, 2.5, lexeme="JUGGLING")], library(clip("beat", category="BEAT")))
    assert [arm.placed.clip.name for arm in plan.gestures] == ["beat"]
    assert actions(plan, "g1") == ["replaced"]


def test_without_any_clip_the_gesture_is_dropped() -> None:
    plan = planned([gesture("g1", 2.0, 2.5, lexeme="JUGGLING")])
    assert (plan.gestures, actions(plan, "g1")) == ((), ["dropped"])


def test_without_gestures_the_arms_rest() -> None:
    plan = planned([])
    assert {(rest.side, rest.pose, rest.start_s, rest.end_s) for rest in plan.rests} == {
        (side, "at_side", 0.0, 4.0) for side in (Hand.LEFT, Hand.RIGHT)
    }


def _random_clips() -> HandMade:
    swift = Markers(0.0, 0.2, 0.2, 0.35, 0.45, 0.45, 0.8)
    hands = (Hand.LEFT, Hand.RIGHT, Hand.BOTH)
    return library(
        *(clip(f"wave_{hand}", hand=hand) for hand in hands),
        *(clip(f"swift_{hand}", hand=hand, markers=swift, from_m=0.2, to_m=0.0) for hand in hands),
        *(clip(f"beat_{hand}", category="BEAT", hand=hand, markers=swift, to_m=0.1) for hand in hands),
    )


@st.composite
def schedules(draw: st.DrawFn) -> Schedule:
    moments = sorted(draw(st.lists(st.floats(0.1, 20.0), max_size=12)))
    behaviors = [
        gesture(
            f"g{number}",
            stroke_s,
            stroke_s + draw(st.floats(0.0, 1.5)),
            lexeme=draw(st.sampled_from(["GREETING", "BEAT", "JUGGLING"])),
            hand=draw(st.sampled_from([Hand.LEFT, Hand.RIGHT, Hand.BOTH])),
            priority=draw(st.integers(1, 9)),
            amount=draw(st.sampled_from([None, 0.3, 0.9])),
        )
        for number, stroke_s in enumerate(moments)
    ]
    phrases = draw(st.sampled_from([(), (Interval(0.0, 6.0), Interval(6.5, 21.0))]))
    return Schedule(tuple(behaviors), 22.0, phrases=phrases, emphases_s=tuple(draw(st.lists(st.floats(0, 20)))))


@given(schedule=schedules(), seed=st.integers(0, 3))
def test_whatever_is_asked_for_the_plan_is_sound(schedule: Schedule, seed: int) -> None:
    plan = plan_gestures(_random_clips(), schedule, seed=seed)
    assert plan == plan_gestures(_random_clips(), schedule, seed=seed)
    told = {decision.behavior for decision in plan.decisions if decision.action == "dropped"}
    late = {decision.behavior for decision in plan.decisions if decision.action == "late"}
    played = {arm.behavior for arm in plan.gestures}
    assert played | told == {each.id for each in schedule.behaviors}
    assert not played & told
    for behavior in schedule.behaviors:
        if behavior.id in played:
            realized_s, asked_s = plan.realized[behavior.id].stroke, behavior.sync.stroke
            assert realized_s is not None
            assert asked_s is not None
            assert asked_s <= realized_s <= asked_s + (LATEST_S if behavior.id in late else 0.02)
            assert realized_s == asked_s or plan.realized[behavior.id].stroke_start == pytest.approx(0.0, abs=1e-9)
            times = [time_s for _point, time_s in plan.realized[behavior.id].in_order()]
            assert times == sorted(times)
            assert times[0] >= 0.0
    for side in (Hand.LEFT, Hand.RIGHT):
        assert_sound_arm(plan, side)


def assert_sound_arm(plan: GesturePlan, side: Hand) -> None:
    """From the first frame to the last the arm is in exactly one place: at rest, in a gesture, or on a way."""
    gestures, rests = plan.of_arm(side)
    for first, second in pairwise(gestures):
        assert first.markers.stroke_end <= first.markers.relax <= first.markers.end <= second.markers.start + 1e-9
        assert second.markers.start < second.markers.stroke_start
    spans = sorted(
        [(each.markers.start, each.markers.end) for each in gestures] + [(r.start_s, r.end_s) for r in rests]
    )
    assert spans[0][0] == 0.0
    assert spans[-1][1] == plan.end_s
    for before, after in pairwise(spans):
        assert before[1] <= after[0] + 1e-9
    for arm in gestures:
        ends = [repeat.end_s for repeat in arm.placed.repeats]
        assert all(arm.markers.stroke_end < end <= arm.markers.relax for end in ends)


@pytest.mark.parametrize(
    ("target", "aim_m", "action"),
    [
        ("door", (3.0, 1.0, 1.0), []),
        ("listener", (0.0, 1.25, 1.25), []),
        ("window", None, ["replaced"]),
        (None, None, []),
    ],
)
def test_pointings_aim_at_places_that_are_known(
    target: str | None, aim_m: tuple[float, float, float] | None, action: list[str]
) -> None:
    pointing = replace(gesture("g1", 2.0, 2.5), target=target)
    clips = library(replace(clip(), aimed=True))
    plan = plan_gestures(clips, Schedule((pointing,), 4.0), seed=0, targets_m={"door": (3.0, 1.0, 1.0)})
    assert plan.gestures[0].placed.aim_m == (aim_m and pytest.approx(aim_m))
    assert actions(plan, "g1") == action


def asked_for(*points: str, name: str = "g1", **times_s: float) -> tuple[Behavior, dict[str, frozenset[str]]]:
    """A gesture with its stroke at 2 s, of which these points are asked for."""
    sync = SyncPoints(**{"start": 1.0, "stroke": 2.0, "relax": times_s.get("stroke", 2.0) + 0.4, "end": 3.4, **times_s})
    asked = Behavior(name, Channel.GESTURE, "GREETING", sync, 0, 0, 1.0, hand=Hand.RIGHT)
    return asked, {name: frozenset(points)}


def played(*gestures: tuple[Behavior, dict[str, frozenset[str]]]) -> list[Markers]:
    """The markers of the right hand in a line that is 9 s long."""
    asked = {name: points for _gesture, stated in gestures for name, points in stated.items()}
    schedule = Schedule(tuple(gesture for gesture, _stated in gestures), 9.0, asked=asked)
    return [each.markers for each in plan_gestures(library(clip()), schedule, seed=0).gestures]


@pytest.mark.parametrize("start_s", [0.9, 1.2, 1.36])
def test_a_way_begins_when_it_is_asked_to(start_s: float) -> None:
    """The stroke starts at 1.7 s, and the clip's way takes .4 s."""
    (made,) = played(asked_for("start", start=start_s))
    assert made.start == pytest.approx(start_s)
    assert made.stroke_start == pytest.approx(1.7)
    assert made.ready - made.start <= 0.6 + 1e-9


@pytest.mark.parametrize("end_s", [2.8, 3.4, 4.5])
def test_a_way_to_rest_ends_when_it_is_asked_to(end_s: float) -> None:
    (made,) = played(asked_for("end", end=end_s))
    assert made.end == pytest.approx(end_s)
    assert made.relax >= made.stroke_end


def test_a_hold_ends_when_it_is_asked_to_however_slow_the_way_to_rest_is() -> None:
    (made,) = played(asked_for("relax", "end", relax=2.5, end=4.5))
    assert (made.relax, made.end) == pytest.approx((2.5, 4.5))


def test_a_hand_is_ready_when_it_is_asked_to_be() -> None:
    (made,) = played(asked_for("start", "ready", ready=1.5))
    assert (made.start, made.ready) == pytest.approx((1.0, 1.5))


@pytest.mark.parametrize(("asked_s", "made_s"), [(0.6, 0.6), (0.9, 0.9), (2.0, 1.0)])
def test_a_stroke_is_stretched_up_to_twice_its_time(asked_s: float, made_s: float) -> None:
    """The clip's takes .5 s, of which .3 s are before the emphasis."""
    starts_s, ends_s = 2.0 - asked_s / 2, 2.0 + asked_s / 2
    (made,) = played(
        asked_for("stroke_start", "stroke_end", stroke_start=starts_s, stroke_end=ends_s, relax=3.5, end=4)
    )
    assert made.stroke_end - made.stroke_start == pytest.approx(made_s)
    assert made.stroke == pytest.approx(2.0)


def test_a_rest_that_is_asked_for_between_two_gestures_is_made() -> None:
    first = asked_for("start", "end", start=1.0, stroke=1.6, end=2.4)
    second = asked_for("start", "end", start=2.5, stroke=3.2, end=4.2, name="g2")
    made, later = played(first, second)
    assert made.end == pytest.approx(2.4)
    assert later.start == pytest.approx(2.5)
