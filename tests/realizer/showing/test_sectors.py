"""Hands of a gesture script go where it says: the wrist at both ends of the stroke, and what cannot be is told."""

import json
from typing import Any

import numpy as np
import pytest

from understudy.errors import InputError
from understudy.model import FloatArray
from understudy.models import Understudy
from understudy.realization import PreparedSchedule, RealizedSchedule, realize_prepared
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.gestures.gesture import Depth, HeightSector, SectorPlace, Sideways
from understudy.realizer.gestures.gesture_space import sector_m
from understudy.schemas.gestures.script import read_script

NEAR_M = 0.09
"""Half of the distance between sectors: the body turns and leans a little while the hand moves."""


def _gesture(name: str = "g1", begin_s: float = 1.0, **said: Any) -> dict[str, Any]:  # noqa: ANN401 - JSON
    stroke = {"start_s": begin_s, "end_s": begin_s + 0.6}
    times = {"start_s": begin_s - 0.5, "relax_s": begin_s + 1.4, "end_s": begin_s + 2.0}
    return {"id": name, "lexeme": "OFFER", "hand": "right", "strokes": [stroke], **times, **said}


def _script(*gestures: dict[str, Any]) -> bytes:
    unit = {"start_s": 0.5, "end_s": 5.0, "gestures": [each["id"] for each in gestures], "rest": "at_side"}
    return json.dumps({"profile": "x", "duration_s": 6, "gestures": gestures, "units": [unit]}).encode()


def _played(understudy: Understudy, content: bytes) -> RealizedSchedule:
    return realize_prepared(understudy.realizer, PreparedSchedule.of(read_script(content)), frame_rate_hz=60)


def _wrists_m(played: RealizedSchedule) -> FloatArray:
    """The right wrist at the start and the end of the stroke, outwards, above the hips, away."""
    skeleton, motion = Skeleton.standing(), played.motion
    sync = motion.realized["g1"]
    assert sync.stroke_start is not None
    assert sync.stroke_end is not None
    frames = np.searchsorted(motion.body.times_s, [sync.stroke_start, sync.stroke_end])
    at_m, _turned = forward(skeleton, motion.body.rotations[frames], motion.body.hips_m[frames])
    return np.asarray((at_m[:, skeleton.index["rightHand"]] - at_m[:, skeleton.index["hips"]]) * [-1, 1, 1])


def _sector_m(told: str) -> FloatArray:
    across, height, depth = told.split()
    return sector_m(SectorPlace(Sideways(across), HeightSector(height), Depth(depth)))


@pytest.mark.parametrize(
    ("begins", "ends"),
    [
        ("XC YCC ZNear", "XC YCC ZMiddle"),
        ("XCC YCC ZMiddle", "XP YUpperC ZMiddle"),
        ("XP YLowerC ZMiddle", "XC YUpperC ZMiddle"),
    ],
)
def test_the_wrist_goes_from_and_to_the_sectors_of_the_script(understudy: Understudy, begins: str, ends: str) -> None:
    played = _played(understudy, _script(_gesture() | {"from": begins, "to": f"{ends} normal"}))
    for wrist_m, sector in zip(_wrists_m(played), (begins, ends), strict=True):
        assert np.linalg.norm(wrist_m - _sector_m(sector)) < NEAR_M
    assert not [each for each in played.motion.decisions if each.action == "placed"]


def test_what_is_out_of_reach_or_too_far_for_its_time_is_told(understudy: Understudy) -> None:
    far = _played(understudy, _script(_gesture(to="XEP YUpperEP ZFar")))
    assert "to XEP YUpperEP ZFar is 6 cm out of reach" in {each.reason for each in far.motion.decisions}
    fast = _played(understudy, _script(_gesture() | {"from": "XEP YLowerEP ZMiddle", "to": "XOppP YUpperP ZMiddle"}))
    told = [each.reason for each in fast.motion.decisions if each.action == "placed"]
    assert any("to be no faster than hands are" in each for each in told)


def test_a_stroke_without_preparation_begins_where_the_one_before_ended() -> None:
    first = _gesture(to="XC YCC ZMiddle") | {"relax_s": 2.0, "end_s": 2.0}
    second = _gesture("g2", 2.0, **{"from": "XEP YCC ZFar", "to": "XP YCC ZMiddle"}) | {"start_s": 2.0}
    performance = read_script(_script(first, second))
    moved = next(each for each in performance.behaviors if each.id == "g2")
    assert moved.way is not None
    assert moved.way.start == ("XC", "YCC", "ZMiddle")
    (notice,) = [each for each in performance.notices if each.code == "script_start"]
    assert "begins where g1 ended, at XC YCC ZMiddle normal, not at XEP YCC ZFar normal" in notice.message


@pytest.mark.parametrize("told", ["XC YCC", "XC YCC ZMiddle ZNear", "XC YCC ZMid", "XC YCC ZMiddle bent"])
def test_what_is_no_place_is_refused(told: str) -> None:
    with pytest.raises(InputError, match=r"gestures\.0\.from: .*is not a place; give one sector each of XEP"):
        read_script(_script(_gesture() | {"from": told}))


def _elbow_m(played: RealizedSchedule) -> FloatArray:
    """The right elbow at the end of the stroke, outwards, above the hips, away."""
    skeleton, motion = Skeleton.standing(), played.motion
    frame = int(np.searchsorted(motion.body.times_s, motion.realized["g1"].stroke_end or 0.0))
    at_m, _turned = forward(skeleton, motion.body.rotations[[frame]], motion.body.hips_m[[frame]])
    elbow_m = at_m[0, skeleton.index["rightLowerArm"]] - at_m[0, skeleton.index["hips"]]
    return np.asarray(elbow_m * [-1, 1, 1])


def test_the_elbow_swivels_as_the_script_says_and_the_wrist_stays(understudy: Understudy) -> None:
    """NGS §3.1: hand and arm at both ends of a stroke are told by three sectors and the arm's swivel."""
    place = "XC YCC ZMiddle"
    played = {
        swivel: _played(understudy, _script(_gesture() | {"from": f"{place} {swivel}", "to": f"{place} {swivel}"}))
        for swivel in ("touch", "normal", "out", "raised")
    }
    touch_m, _normal_m, out_m, raised_m = map(_elbow_m, played.values())
    assert out_m[0] > touch_m[0] + 0.05
    assert raised_m[1] > out_m[1] + 0.04
    for each in played.values():
        assert np.linalg.norm(_wrists_m(each)[1] - _sector_m(place)) < NEAR_M


def test_an_elbow_that_cannot_be_where_its_swivel_is_is_told(understudy: Understudy) -> None:
    """With the palm up an elbow is not far out; a fist's can be."""

    def told(lexeme: str, swivel: str) -> list[str]:
        script = _script(_gesture(lexeme=lexeme, to=f"XC YCC ZMiddle {swivel}"))
        decisions = _played(understudy, script).motion.decisions
        return [each.reason for each in decisions if each.action == "placed"]

    (reason,) = told("OFFER", "out")
    assert reason.startswith("to XC YCC ZMiddle: the right elbow is ")
    assert reason.endswith("° out, not 30°, as far as wrist and joints allow")
    assert told("BEAT", "out") == told("OFFER", "normal") == []


def test_offset_tracks_of_a_script_are_added_to_the_gestures_own(understudy: Understudy) -> None:
    plain = _played(understudy, _script(_gesture()))
    turned = _played(understudy, _script(_gesture(tracks=["held chest 0 20 0"])))
    chest = Skeleton.standing().index["chest"]
    frame = int(np.searchsorted(plain.motion.body.times_s, plain.motion.realized["g1"].stroke_end or 0.0))
    one, other = (each.motion.body.rotations[frame, chest] for each in (plain, turned))
    assert np.degrees(2 * np.arccos(min(1.0, abs(float(one @ other))))) > 8
    assert not [each for each in turned.motion.decisions if each.action == "placed"]


@pytest.mark.parametrize(
    ("track", "told"),
    [
        ("held chest 0 12", "'held chest 0 12' is not a track; give form, joint and three angles"),
        ("held chset 0 12 0", "chset"),
        ("held chest 0 60 0", "60 is outside -45 … 45°"),
        ("circling Hand 0 12 0", "gives its turns after the angles"),
    ],
)
def test_a_track_that_cannot_be_read_is_told(track: str, told: str) -> None:
    with pytest.raises(InputError) as wrong:
        read_script(_script(_gesture(tracks=[track])))
    assert "gestures.0.tracks.0" in wrong.value.message
    assert told in wrong.value.message
