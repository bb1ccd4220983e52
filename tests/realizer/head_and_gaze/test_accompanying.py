"""The eyes go where a gesture shows something, then the head, then the hand."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.movements import BODY, TIMES_S, behavior, faced, schedule, seen_by
from understudy.model import Behavior, Channel, FloatArray, Hand, Interval, Schedule, Word
from understudy.models import load_gestures
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import forward
from understudy.realizer.geometry.rotations import to_pitch_yaw_roll
from understudy.realizer.head_and_gaze.accompanying import ALONG, AT_THE_HAND, Look, accompanying_looks, with_looks
from understudy.realizer.head_and_gaze.gaze import apply_gaze
from understudy.realizer.scheduling.gesture_controller import apply_gestures
from understudy.realizer.scheduling.planning import plan_gestures
from understudy.realizer.torso.idle import idle_motion

LIBRARY = load_gestures()


def shown(lexeme: str, hand: Hand = Hand.RIGHT, **changes: object) -> Behavior:
    times_s = (1.5, 1.9, 1.9, 2.2, 2.2, 3.0, 3.5)
    return behavior(Channel.GESTURE, lexeme, *times_s, hand=hand, amount=0.5, **changes)


def moved(planned: Schedule) -> tuple[BodyMotion, tuple[Look, ...]]:
    plan = plan_gestures(LIBRARY, planned, seed=0)
    body = apply_gestures(BODY, idle_motion(BODY, TIMES_S, planned, seed=2), plan, seed=2)
    looks = accompanying_looks(BODY, body, planned, plan)
    at_m = {str(look.gaze.target): look.at_m for look in looks}
    return apply_gaze(BODY, body, with_looks(planned, looks), targets_m=at_m)[0], looks


def apart_deg(body: BodyMotion, look: Look) -> FloatArray:
    """Between the line of sight and the way to what is shown (T,)."""
    from_m = faced(body).eyes_m.mean(axis=1)
    sight, way = seen_by(body) - from_m, np.array(look.at_m) - from_m
    cosine = np.sum(sight * way, axis=1) / np.linalg.norm(sight, axis=1) / np.linalg.norm(way, axis=1)
    return np.asarray(np.degrees(np.arccos(np.clip(cosine, -1, 1))))


def set_out_s(course: FloatArray) -> float:
    """When a curve that is at rest at 1.1 s begins to move away, by a twentieth of its whole way until 2.2 s."""
    start, there = np.searchsorted(TIMES_S, [1.1, 2.2])
    away = np.abs(course - course[start])
    return float(TIMES_S[start + np.argmax(away[start : there + 1] > 0.05 * away[there])])


@pytest.mark.parametrize(("lexeme", "hand"), [("POINT_LEFT", Hand.LEFT), ("THERE", Hand.RIGHT)])
def test_eyes_then_head_then_hand_and_they_are_on_what_is_pointed_at(lexeme: str, hand: Hand) -> None:
    body, (look,) = moved(schedule(shown(lexeme, hand)))
    places_m = forward(BODY, body.rotations, body.hips_m)[0]
    apart = apart_deg(body, look)
    wrist_m = places_m[:, BODY.index[f"{hand.value}Hand"]]
    way = np.linalg.norm(wrist_m - wrist_m[np.searchsorted(TIMES_S, 1.1)], axis=1)
    pitch, yaw, _roll = to_pitch_yaw_roll(faced(body).orientation)
    turn = np.hypot(pitch - pitch[66], yaw - yaw[66])
    eyes_s, head_s, hand_s = set_out_s(apart), set_out_s(turn), set_out_s(way)
    assert 0.08 <= hand_s - eyes_s <= 0.30
    assert eyes_s < head_s < hand_s
    assert apart[(TIMES_S > 1.85) & (TIMES_S < 2.2)].max() < 3
    aim = wrist_m - places_m[:, BODY.index[f"{hand.value}UpperArm"]]
    sight = seen_by(body) - faced(body).eyes_m.mean(axis=1)
    cosine = np.sum(sight * aim, axis=1) / np.linalg.norm(sight, axis=1) / np.linalg.norm(aim, axis=1)
    assert np.degrees(np.arccos(cosine[np.searchsorted(TIMES_S, 2.2)])) < 25


def test_what_is_measured_is_looked_at_and_the_eyes_come_back() -> None:
    body, (look,) = moved(schedule(shown("WIDE", Hand.BOTH)))
    listener = schedule()
    back, _none = moved(listener)
    assert apart_deg(body, look)[np.searchsorted(TIMES_S, 2.1)] < 3
    relax_s = look.gaze.sync.end + 0.2
    after = relax_s < TIMES_S
    assert np.linalg.norm((seen_by(body) - seen_by(back))[after], axis=1).max() < 0.1


def test_the_eyes_are_back_with_the_last_word() -> None:
    word = Word(0, "there", Interval(2.55, 2.9))
    _body, (look,) = moved(replace(schedule(shown("THERE")), words=(word,)))
    assert look.gaze.sync.relax is not None
    assert look.gaze.sync.relax <= 2.55


def test_looks_of_the_schedule_go_first_and_eyes_that_wander_make_way() -> None:
    asked = behavior(Channel.GAZE, "LOOK", 1.5, 1.75, 2.6, 2.8, direction="UP", amount=0.5, moment="m3")
    assert moved(schedule(shown("THERE"), asked))[1] == ()
    wanders = behavior(
        Channel.GAZE, "LOOK", 1.0, 1.2, 2.6, 2.8, direction="UP", amount=0.5, reason="the eyes wander off"
    )
    body, (look,) = moved(schedule(shown("THERE"), wanders))
    assert apart_deg(body, look)[np.searchsorted(TIMES_S, 2.1)] < 3
    assert "watched" in look.decision.action
    assert look.hand_s - look.gaze.sync.start == pytest.approx(0.15, abs=0.001)


def test_nobody_looks_at_their_own_hands_all_the_time() -> None:
    """Four places one after another: the eyes go with the first two, as of a contrast, and are away for the third."""
    strokes_s = np.array([0.5, 0.8, 0.8, 1.1, 1.1, 1.3, 1.7])
    placed = [
        behavior(Channel.GESTURE, lexeme, *(strokes_s + 1.2 * number), hand=hand, amount=0.5)
        for number, (lexeme, hand) in enumerate([("PLACE_LEFT", Hand.LEFT), ("PLACE_RIGHT", Hand.RIGHT)] * 2)
    ]
    _body, looks = moved(schedule(*placed))
    assert [look.gaze.target for look in looks] == [placed[number].id for number in (0, 1, 3)]


def test_gestures_that_show_nothing_are_not_looked_at_and_all_names_exist() -> None:
    assert moved(schedule(shown("OPEN_HAND")))[1] == ()
    assert set(LIBRARY.categories) >= ALONG | AT_THE_HAND


def test_everything_that_is_pointed_at_is_looked_at() -> None:
    strokes_s = np.array([0.5, 0.8, 0.8, 1.1, 1.1, 1.3, 1.7])
    placed = [
        behavior(Channel.GESTURE, "POINT_FRONT", *(strokes_s + 1.2 * number), hand=hand, amount=0.5)
        for number, hand in enumerate((Hand.LEFT, Hand.RIGHT, Hand.LEFT))
    ]
    assert [look.gaze.target for look in moved(schedule(*placed))[1]] == [each.id for each in placed]


def test_nobody_turns_to_the_side_to_look_at_the_ground() -> None:
    _body, (look,) = moved(schedule(shown("DOWN")))
    x, y, z = look.at_m
    assert y < 0
    assert abs(np.degrees(np.arctan2(x, z))) < 65
