"""Behaviours as strips: moved, muted or deleted, they change motion and BML; BML of others comes in."""

import json
import re
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.plugins.blender.documents import BML, SMARTBODY
from tests.plugins.blender.in_blender.tracks import behavior_strip, heads, id_of, tracks

Bpy = Any


def schedule(armature: Bpy) -> dict[str, tuple[float, float]]:
    """Starts and ends of the behaviours as they were laid, in seconds."""
    found = {}
    for each in record_of(armature):
        found[each["id"]] = (min(each["points_s"].values()), max(each["points_s"].values()))
    return found


def record_of(armature: Bpy) -> Any:
    """The behaviours of the first performance as they were laid."""
    return json.loads(armature.understudy.performances[0].behaviors)


def test_every_behaviour_is_a_strip_at_its_time(performed: Bpy) -> None:
    strips = [each for name, there in tracks(performed).items() if " BML " in name for each in there]
    times = schedule(performed)
    assert {id_of(each) for each in strips} == set(times)
    for each in strips:
        start_s, end_s = times[id_of(each)]
        assert each.frame_start - 1 == pytest.approx(30 * start_s, abs=1)
        assert each.frame_end - 1 == pytest.approx(30 * end_s, abs=1)
    marks = {marker.name for marker in behavior_strip(performed, "gesture1").action.pose_markers}
    assert marks >= {"start", "stroke", "relax", "end"}


def test_strips_move_no_bone(blender: Bpy, performed: Bpy) -> None:
    with_strips = heads(blender, performed, 30)
    for track in performed.animation_data.nla_tracks:
        track.mute = " BML " in track.name
    assert all(np.allclose(heads(blender, performed, 30)[bone], place) for bone, place in with_strips.items())


def test_the_phases_are_seen_in_the_graph(blender: Bpy, performed: Bpy) -> None:
    """Of the last gesture after which the hand has time to come to rest."""
    gestures = [each for each in record_of(performed) if each["kind"] == "gesture"]
    last = [each["id"] for each in gestures if each["points_s"]["relax"] < each["points_s"]["end"]][-1]
    markers = behavior_strip(performed, last).action.pose_markers
    start, ready, relax, end = (markers[name].frame for name in ("start", "ready", "relax", "end"))
    at = behavior_strip(performed, last).frame_start
    seen = []
    for frame in (start, ready + 1, relax - 1, end + 1):
        blender.context.scene.frame_set(int(at + frame))
        seen.append(performed["understudy_gesture"])
    assert seen == pytest.approx([0, 1, 1, 0], abs=0.05)


def test_a_moved_strip_moves_the_gesture_and_leaves_the_rest(blender: Bpy, performed: Bpy) -> None:
    before = schedule(performed)
    last = [name for name in before if name.startswith("gesture")][-1]
    behavior_strip(performed, last).frame_start_ui += 15
    blender.ops.understudy.play_strips()
    after = schedule(performed)
    assert after[last][0] == pytest.approx(before[last][0] + 0.5, abs=0.05)
    (joined,) = [
        name for name, (_start_s, end_s) in before.items() if name[:7] == "gesture" and end_s == before[last][0]
    ]
    assert after[joined] == pytest.approx((before[joined][0], after[last][0]), abs=0.05)
    kept = {name for name in before if not name.startswith((last, joined, "gaze", "eyes"))}
    assert all(after[name] == pytest.approx(before[name], abs=0.05) for name in kept & after.keys())
    assert len(performed.understudy.performances) == 1
    assert behavior_strip(performed, last).frame_start == pytest.approx(moved_to(after[last][0]), abs=1)


def moved_to(start_s: float) -> float:
    return 1 + 30 * start_s


def test_a_muted_strip_is_not_played(blender: Bpy, performed: Bpy) -> None:
    """Both gestures of the first sentence: the second raises the hand while the first still strokes."""
    raised = hand_m(blender, performed)
    for muted in ("gesture1", "gesture2"):
        behavior_strip(performed, muted).mute = True
    blender.ops.understudy.play_strips()
    assert not {"gesture1", "gesture2"} & schedule(performed).keys()
    assert not re.search("gesture[12]", performed.understudy.performances[0].bml.as_string())
    assert hand_m(blender, performed) < raised - 0.05


def hand_m(blender: Bpy, armature: Bpy) -> float:
    """How high the right hand is while the first gesture strokes, at .8 s."""
    return float(heads(blender, armature, 25)["rightHand"][1])


def written_s(bml: bytes) -> dict[str, tuple[float, float]]:
    """Starts and ends as they stand in the file."""
    timed = [each for each in ET.fromstring(bml) if each.get("end")]
    return {each.attrib["id"]: (float(each.attrib["start"]), float(each.attrib["end"])) for each in timed}


def test_export_writes_the_strips_as_they_are(blender: Bpy, performed: Bpy, tmp_path: Path) -> None:
    written = tmp_path / "line.bml"
    blender.ops.understudy.export_bml(filepath=str(written))
    before = written_s(written.read_bytes())
    behavior_strip(performed, "head1").frame_start_ui += 6
    deleted = behavior_strip(performed, "gesture2")
    track = next(each for each in performed.animation_data.nla_tracks if deleted.name in each.strips)
    track.strips.remove(deleted)
    blender.ops.understudy.export_bml(filepath=str(written))
    after = written_s(written.read_bytes())
    assert after["head1"] == pytest.approx([time_s + 0.2 for time_s in before["head1"]])
    assert after.keys() == before.keys() - {"gesture2"}
    assert after["gesture1"] == before["gesture1"]


@pytest.mark.parametrize(("content", "strips"), [(BML, {"gesture1", "head1", "face1"}), (SMARTBODY, {"g1", "h1"})])
def test_anybodys_bml_comes_in(blender: Bpy, mannequin: Bpy, tmp_path: Path, content: bytes, strips: set[str]) -> None:
    path = tmp_path / "theirs.bml"
    path.write_bytes(content)
    blender.context.scene.frame_current = 10
    blender.ops.understudy.import_bml(filepath=str(path), by_hand=content is BML)
    assert strips <= set(schedule(mannequin))
    assert tracks(mannequin)["Understudy body"][0].frame_start == 10
    assert mannequin.understudy.performances[0].name == "theirs"


def test_what_was_read_from_bml_cannot_be_performed_again_but_played(
    blender: Bpy, mannequin: Bpy, tmp_path: Path
) -> None:
    path = tmp_path / "theirs.bml"
    path.write_bytes(BML)
    blender.ops.understudy.import_bml(filepath=str(path))
    with pytest.raises(RuntimeError, match="read from BML"):
        blender.ops.understudy.perform_again()
    behavior_strip(mannequin, "gesture1").frame_start_ui += 15
    blender.ops.understudy.play_strips()
    (stroke,) = [each["points_s"]["stroke"] for each in record_of(mannequin) if each["id"] == "gesture1"]
    assert stroke == pytest.approx(0.6 + 0.5, abs=0.02)


@pytest.mark.parametrize(("content", "said"), [(b"{}", "not BML"), (BML.replace(b"<head ", b"<heed "), "heed")])
def test_wrong_bml_is_told(blender: Bpy, mannequin: Bpy, tmp_path: Path, content: bytes, said: str) -> None:
    path = tmp_path / "wrong.bml"
    path.write_bytes(content)
    assert mannequin.name
    with pytest.raises(RuntimeError, match=said):
        blender.ops.understudy.import_bml(filepath=str(path))


def test_without_a_performance_there_is_nothing_to_play(blender: Bpy, mannequin: Bpy) -> None:
    assert mannequin.name
    with pytest.raises(RuntimeError, match="no performance yet"):
        blender.ops.understudy.play_strips()
