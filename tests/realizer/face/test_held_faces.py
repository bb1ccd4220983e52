"""The expressions that a tone of voice holds over a phrase, as they are played while the phrase is spoken."""

from pathlib import Path

import numpy as np
import pytest

from benchmarks.realizer.face.lip_closure import lip_closures
from tests.support.words.speaking import faced, said, times
from understudy.behavior.table.behavior_table import load_table
from understudy.model import Behavior, FloatArray, SyncPoints
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.face.face_tables import INDEX

TABLE = load_table(Path(__file__).resolve().parents[3] / "lexicon" / "behaviors.yaml")
SPOKEN = said("HH AW M EH N IY P IY P AH L V UW D B AO T SH UH D", phone_s=0.09)
HELD = slice(round(60 * 0.7), round(60 * 2.0))


def held(*names: str) -> tuple[Behavior, ...]:
    """These entries of the table, whole from .55 to 2.2 s of a line that is spoken from .5 to 2.3 s."""
    entries = [TABLE.entry(name) for name in names]
    rise_s, fall_s = entries[0].timing.preparation.usual_s, entries[0].timing.retraction.usual_s
    sync = SyncPoints(start=0.55 - rise_s, ready=0.55, relax=2.2, end=2.2 + fall_s)
    return tuple(
        Behavior(name, entry.channel, entry.lexeme, sync, 0, 0, 1.0, amount=entry.amount)
        for name, entry in zip(names, entries, strict=True)
    )


def played(*names: str) -> FloatArray:
    return faced(SPOKEN, held(*names), end_s=3.2)


ATTITUDES = {
    "happy": ("held_smile", "held_cheeks"),
    "sad": ("held_oblique_brows", "held_mouth_down"),
    "angry": ("held_frown", "held_narrow_eyes", "held_lip_press"),
    "disgusted": ("held_frown", "held_nose_wrinkle"),
    "surprised": ("held_brow_raise", "held_wide_eyes"),
    "afraid": ("held_oblique_brows", "held_wide_eyes", "held_lip_stretch"),
}
SHOWN_BY = {
    "happy": ("mouthSmile", "cheekSquint"),
    "sad": ("browInnerUp", "mouthFrown"),
    "angry": ("browDown", "mouthPress"),
    "disgusted": ("browDown", "noseSneer"),
    "surprised": ("browInnerUp", "browOuterUp"),
    "afraid": ("browInnerUp", "eyeWide"),
}


@pytest.mark.parametrize("tone", ATTITUDES)
def test_a_held_expression_shows_while_the_words_are_spoken_and_lets_the_lips_close(tone: str) -> None:
    shapes = played(*ATTITUDES[tone])
    for name in SHOWN_BY[tone]:
        courses = [shapes[HELD, INDEX[each]] for each in SHAPES if each.startswith(name) and not each.endswith("Right")]
        most = np.max(courses, axis=0)
        assert np.mean(most >= 0.45) * (HELD.stop - HELD.start) / 60 >= 0.6, name
        assert most.max() <= 0.85
    assert all(each.closed for each in lip_closures(SPOKEN, shapes, times(3.2)))


def test_a_smile_reaches_the_eyes() -> None:
    smiling, neutral = played(*ATTITUDES["happy"]), faced(SPOKEN, end_s=3.2)
    for name, at_least in (("cheekSquintLeft", 0.5), ("eyeSquintLeft", 0.12)):
        assert np.mean(smiling[HELD, INDEX[name]] - neutral[HELD, INDEX[name]]) > at_least


@pytest.mark.parametrize("name", ["mouthSmile", "browDown", "noseSneer"])
def test_held_faces_are_uneven_but_not_one_sided(name: str) -> None:
    shapes = played("held_smile", "held_frown", "held_nose_wrinkle")
    left, right = (shapes[HELD, INDEX[name + side]].mean() for side in ("Left", "Right"))
    assert 0.8 < right / left < 0.98


def test_an_attitude_comes_and_goes_in_about_three_tenths_of_a_second() -> None:
    brow = played("held_frown")[:, INDEX["browDownLeft"]]
    reached, left = np.flatnonzero(brow > 0.9 * brow.max())[[0, -1]] / 60
    begun, ended = np.flatnonzero(brow > 0.1 * brow.max())[[0, -1]] / 60
    assert 0.12 < reached - begun < 0.35
    assert 0.15 < ended - left < 0.45


def test_a_neutral_face_is_neutral() -> None:
    shapes = faced(SPOKEN, end_s=3.2)
    for name in ("mouthSmile", "mouthFrown", "browDown", "noseSneer", "cheekSquint", "eyeWide", "eyeSquint"):
        assert shapes[:, INDEX[name + "Left"]].max() < (0.25 if name == "mouthSmile" else 0.06), name
