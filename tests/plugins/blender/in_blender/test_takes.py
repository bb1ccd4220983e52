"""Takes and notes: what was done to strips holds in every take until it is cleared; takes can be gone back to."""

import json
from typing import Any

import numpy as np
import pytest

from tests.plugins.blender.in_blender.tracks import behavior_strip, heads, id_of, tracks

Bpy = Any
FRAME_S = 1 / 30


def gestures(armature: Bpy) -> list[dict[str, Any]]:
    """The gestures of the take that is shown."""
    written = json.loads(armature.understudy.performances[0].behaviors)
    return [each for each in written if each["kind"] == "gesture"]


def placed(armature: Bpy, lexeme: str) -> dict[str, Any]:
    """The gesture with this lexeme that a note made or moved."""
    return next(each for each in gestures(armature) if each["lexeme"] == lexeme and each["edit"] is not None)


def strips(armature: Bpy) -> dict[str, float]:
    """The first frames of all behaviours' strips by their ids."""
    there = (each for on_track in tracks(armature).values() for each in on_track)
    return {id_of(each): each.frame_start for each in there if id_of(each)}


def notes(armature: Bpy) -> list[str]:
    return [each.name for each in armature.understudy.performances[0].notes]


def test_what_was_moved_and_what_was_muted_hold_in_every_take(blender: Bpy, performed: Bpy) -> None:
    """A move, then a mute, then nothing: three takes, the first of which comes after Play Strips."""
    moved = gestures(performed)[-1]
    wanted_s = moved["points_s"]["stroke"] + 0.4
    behavior_strip(performed, moved["id"]).frame_start_ui += 12
    blender.ops.understudy.play_strips()
    blender.ops.understudy.perform_again()
    assert placed(performed, moved["lexeme"])["points_s"]["stroke"] == pytest.approx(wanted_s, abs=FRAME_S)
    muted = gestures(performed)[0]
    behavior_strip(performed, muted["id"]).mute = True
    for _take in range(2):
        blender.ops.understudy.perform_again()
        assert placed(performed, moved["lexeme"])["points_s"]["stroke"] == pytest.approx(wanted_s, abs=FRAME_S)
        assert not [
            each for each in gestures(performed) if (each["lexeme"], each["first"]) == (muted["lexeme"], muted["first"])
        ]
    assert len(notes(performed)) == 2
    assert moved["lexeme"].lower().replace("_", " ") in notes(performed)[0]
    assert "moved" in notes(performed)[0]
    assert notes(performed)[1].endswith("muted")


def test_another_press_is_another_take_and_each_can_be_gone_back_to(blender: Bpy, performed: Bpy) -> None:
    record = performed.understudy.performances[0]
    first, places = strips(performed), heads(blender, performed, 60)
    blender.ops.understudy.perform_again()
    assert [take.name for take in record.takes] == ["Take 1", "Take 2"]
    assert [json.loads(take.order)["options"]["seed"] for take in record.takes] == [0, 1]
    second, elsewhere = strips(performed), heads(blender, performed, 60)
    assert second != first
    blender.ops.understudy.show_take(number=0)
    assert strips(performed) == first
    assert all(np.allclose(heads(blender, performed, 60)[bone], place, atol=1e-6) for bone, place in places.items())
    assert record.bml == record.takes[0].bml != record.takes[1].bml
    blender.ops.understudy.show_take(number=1)
    assert strips(performed) == second
    assert all(np.allclose(heads(blender, performed, 60)[bone], at, atol=1e-6) for bone, at in elsewhere.items())


def test_a_take_that_is_not_shown_is_removed_with_its_actions(blender: Bpy, performed: Bpy) -> None:
    record = performed.understudy.performances[0]
    alone = len(blender.data.actions)
    blender.ops.understudy.perform_again()
    with pytest.raises(RuntimeError, match="is shown"):
        blender.ops.understudy.remove_take(number=1)
    blender.ops.understudy.remove_take(number=0)
    assert [take.name for take in record.takes] == ["Take 2"]
    assert len(blender.data.actions) < 2 * alone
    blender.ops.understudy.forget(name=record.name)
    assert not [action for action in blender.data.actions if "understudy_performance" in action]
    assert not [text for text in blender.data.texts if text.name.startswith(performed.name)]


def test_a_cleared_note_holds_no_more_and_its_strip_goes_back(blender: Bpy, performed: Bpy) -> None:
    moved = gestures(performed)[-1]
    laid = strips(performed)[moved["id"]]
    behavior_strip(performed, moved["id"]).frame_start_ui += 12
    blender.ops.understudy.perform_again()
    blender.ops.understudy.show_take(number=0)
    assert strips(performed)[moved["id"]] == laid + 12
    blender.ops.understudy.clear_notes(number=0)
    assert notes(performed) == []
    assert strips(performed)[moved["id"]] == laid


def test_a_locked_strip_is_made_in_every_take(blender: Bpy, performed: Bpy) -> None:
    locked = gestures(performed)[1]
    behavior_strip(performed, locked["id"]).select = True
    blender.ops.understudy.lock_strips()
    assert notes(performed)[0].endswith("locked")
    blender.ops.understudy.perform_again()
    again = placed(performed, locked["lexeme"])
    assert again["points_s"]["stroke"] == pytest.approx(locked["points_s"]["stroke"], abs=FRAME_S)


def test_takes_and_notes_are_there_after_saving(blender: Bpy, performed: Bpy, tmp_path: Any) -> None:
    moved, name = gestures(performed)[-1], performed.name
    first = strips(performed)
    behavior_strip(performed, moved["id"]).frame_start_ui += 12
    blender.ops.understudy.perform_again()
    blender.ops.wm.save_as_mainfile(filepath=str(tmp_path / "takes.blend"))
    blender.ops.wm.open_mainfile(filepath=str(tmp_path / "takes.blend"))
    again = blender.data.objects[name]
    blender.context.view_layer.objects.active = again
    assert len(notes(again)) == 1
    blender.ops.understudy.show_take(number=0)
    assert strips(again).keys() == first.keys()


def test_a_strip_that_lands_elsewhere_says_why(blender: Bpy, performed: Bpy, capfd: Any) -> None:
    """Put before the line begins, where there is no time to raise the hand."""
    first = gestures(performed)[0]
    behavior_strip(performed, first["id"]).frame_start_ui -= 18
    blender.ops.understudy.play_strips()
    told = capfd.readouterr().out
    assert "than its strip was put" in told or "is not played" in told
