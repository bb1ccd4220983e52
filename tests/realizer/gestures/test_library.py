"""Clips: markers, hands and the speed of the stroke, from definitions written by hand."""

from pathlib import Path

import pytest

from tests.realizer.gestures.test_checking import frames
from tests.support.motion.gesture_files import gesture, read_one
from understudy.authoring.catalogue import load_gestures
from understudy.bml.writing.smartbody_tables import shipped_tables
from understudy.errors import AuthoringError, InputError
from understudy.model import Hand, Level
from understudy.model.figure import GestureManner
from understudy.realizer.gestures.gesture import FrameType, Markers
from understudy.realizer.gestures.library import EMPHASIS, LAST_RESORT, Library, clip, relative_markers

EVERY_MARKER = "start preparation ready stroke_start stroke stroke_end hold relax retraction end"


def markers(folder: Path, types: str) -> Markers:
    """Of a gesture with a frame of each type, one every 0.05."""
    return relative_markers(read_one(folder, frames(*types.split())).frames)


def test_markers_are_where_their_frames_are(tmp_path: Path) -> None:
    assert markers(tmp_path, EVERY_MARKER) == Markers(0, 0.1, 0.15, 0.2, 0.25, 0.35, 0.45)


@pytest.mark.parametrize(
    ("types", "expected"),
    [
        ("stroke_start stroke_end", Markers(0, 0, 0, 0.05 * EMPHASIS, 0.05, 0.05, 0.05)),
        ("preparation stroke_start stroke stroke_end", Markers(0, 0.05, 0.05, 0.1, 0.15, 0.15, 0.15)),
        ("preparation ready stroke retraction", Markers(0, 0.05, 0.05, 0.1, 0.1, 0.1, 0.15)),
        ("stroke_start stroke_end hold hold retraction end", Markers(0, 0, 0, 0.05 * EMPHASIS, 0.05, 0.15, 0.25)),
        ("stroke_start stroke stroke stroke stroke_end", Markers(0, 0, 0, 0.1, 0.2, 0.2, 0.2)),
    ],
)
def test_markers_that_no_frame_is(tmp_path: Path, types: str, expected: Markers) -> None:
    found = markers(tmp_path, types)
    for name in Markers.__slots__:
        assert getattr(found, name) == pytest.approx(getattr(expected, name)), name


def test_tempo_sets_the_time(tmp_path: Path) -> None:
    """2 s of gesture from 0.25 to 0.75 at double tempo."""
    definition = read_one(tmp_path, gesture("EXPRESSIVITY medium tempo 2"))
    made = clip(definition, Level.MEDIUM, Hand.LEFT, "TRIAL")
    assert (made.markers.stroke_start, made.markers.stroke_end) == pytest.approx((0.25, 0.75))
    assert [key.time_s for key in made.keys] == pytest.approx([0.25, 0.75])
    assert [key.type for key in made.keys] == [FrameType.STROKE_START, FrameType.STROKE_END]


def test_the_stroke_s_speed_grows_with_amplitude_and_tempo(tmp_path: Path) -> None:
    """From XC ZNear to XP ZFar: .16 m out and .22 m away in 1 s, .272 m/s."""
    definition = read_one(
        tmp_path, gesture("EXPRESSIVITY low amplitude 0.5 tempo 1\nEXPRESSIVITY high amplitude 1.5 tempo 2")
    )
    speeds = [clip(definition, level, Hand.RIGHT, "TRIAL").stroke_speed_m_s for level in Level]
    assert speeds == pytest.approx([0.136, 0.272, 0.816], abs=1e-3)


def test_a_place_left_open_is_on_the_way(tmp_path: Path) -> None:
    """The hand goes out and back in the stroke: the way counts, not the distance of its ends."""
    there = "FRAMETYPE stroke_start\nARM XC YCC ZNear\nENDFRAME\nSTARTFRAME 0.5\nFRAMETYPE stroke\nARM XP YCC ZNear"
    back = "FRAMETYPE stroke_end\nENDFRAME\nSTARTFRAME 1\nFRAMETYPE hold\nARM XC YCC ZNear"
    made = clip(read_one(tmp_path, gesture(first=there, last=back)), Level.MEDIUM, Hand.RIGHT, "TRIAL")
    assert made.stroke_speed_m_s == pytest.approx(0.16 + 0.08)


def test_arms_that_take_part(tmp_path: Path) -> None:
    one = read_one(tmp_path, gesture())
    both = read_one(tmp_path, gesture("ARMS both", last="FRAMETYPE stroke_end\nARM XP YCC ZFar\nOTHER ARM XC YCC ZFar"))
    for hand, left, right in ((Hand.LEFT, True, False), (Hand.RIGHT, False, True), (Hand.BOTH, True, True)):
        for definition in (one, both):
            for key, frame in zip(clip(definition, Level.LOW, hand, "X").keys, definition.frames, strict=True):
                assert key.right == (frame.leading if right else None)
                beside = frame.other if hand is Hand.BOTH and frame.other else frame.leading
                assert key.left == (beside if left else None)


def library(folder: Path, *texts: str, aliases: str = "") -> Library:
    for number, text in enumerate(texts):
        (folder / f"{number}.gesture").write_text(text, encoding="utf-8")
    if aliases:
        (folder / "aliases.yaml").write_text(aliases, encoding="utf-8")
    return Library.load(folder)


def names(found: Library, hand: Hand, level: Level = Level.MEDIUM) -> list[str]:
    return [clip.name for clip in found.clips("BEAT", level, hand)]


def test_files_and_folders_are_read_in_the_order_of_their_names(tmp_path: Path) -> None:
    (tmp_path / "inside").mkdir()
    (tmp_path / "inside" / "a.gesture").write_text(gesture("CATEGORY BEAT", name="last"), encoding="utf-8")
    found = library(tmp_path, gesture("CATEGORY BEAT WE", name="one") + gesture("CATEGORY BEAT", name="two"))
    assert found.categories == ("BEAT", "WE")
    assert names(found, Hand.LEFT) == ["one", "two", "last"]
    assert [clip.name for clip in found.clips("WE", Level.LOW, Hand.RIGHT)] == ["one"]
    assert found.definition("last").path == tmp_path / "inside" / "a.gesture"
    assert found.clips("YOU", Level.LOW, Hand.RIGHT) == ()


def test_hands(tmp_path: Path) -> None:
    found = library(
        tmp_path, *(gesture(f"CATEGORY BEAT\nARMS {arms}", name=arms) for arms in ("left", "right", "both"))
    )
    assert [names(found, hand) for hand in Hand] == [["left"], ["right"], ["both"]]


def test_one_hand_makes_what_both_do_only_where_there_is_nothing_else(tmp_path: Path) -> None:
    both = gesture("CATEGORY BEAT\nARMS both", name="both")
    assert names(library(tmp_path, both), Hand.LEFT) == ["both"]
    found = library(tmp_path, both, gesture("CATEGORY BEAT", name="one"))
    assert [names(found, hand) for hand in Hand] == [["one"], ["one"], ["both"]]


def test_both_hands_mirror_what_one_does_only_where_there_is_nothing_else(tmp_path: Path) -> None:
    found = library(tmp_path, gesture("CATEGORY BEAT", name="one"))
    (clip,) = found.clips("BEAT", Level.HIGH, Hand.BOTH)
    assert clip.hand is Hand.BOTH
    assert clip.keys[0].left == clip.keys[0].right is not None


def test_what_one_hand_means_is_not_mirrored(tmp_path: Path) -> None:
    """A hand that points to its own side would point to the other as the other hand."""
    found = library(tmp_path, gesture("CATEGORY BEAT\nARMS left", name="left"))
    assert [names(found, hand) for hand in Hand] == [["left"], [], []]


def test_levels(tmp_path: Path) -> None:
    found = library(tmp_path, gesture("CATEGORY BEAT\nLEVELS high"), gesture("CATEGORY BEAT", name="any"))
    assert [names(found, Hand.RIGHT, level) for level in Level] == [["any"], ["any"], ["trial", "any"]]


def test_every_mistake_of_every_file(tmp_path: Path) -> None:
    wrong = gesture("ARMS no", name="wrong")
    with pytest.raises(AuthoringError) as caught:
        library(tmp_path, wrong + wrong, wrong.replace("wrong", "late"))
    assert [(one.path.name, one.line) for one in caught.value.mistakes] == [
        ("0.gesture", 4),
        ("0.gesture", 14),
        ("0.gesture", 16),
        ("1.gesture", 4),
    ]


def test_lexemes_of_others(tmp_path: Path) -> None:
    beat, point = gesture("CATEGORY BEAT", name="beat"), gesture("CATEGORY POINT_LEFT", name="point")
    found = library(tmp_path, beat, point, aliases="aliases:\n  POINT_LEFT: [DEICTIC_LEFT]\n")
    lexemes = ("POINT_LEFT", "point-left", "Point Left", "deictic.left", "SING")
    assert [found.nearest(one) for one in lexemes] == [*["POINT_LEFT"] * 4, "BEAT"]
    assert Library.of(()).nearest("SING") is None
    assert (found.category_of("deictic.left"), found.category_of("SING")) == ("POINT_LEFT", None)


@pytest.mark.parametrize(
    ("aliases", "line", "told"),
    [
        ("aliases:\n  BEET: [BATON]", 2, "no gesture shows BEET; did you mean 'BEAT'?"),
        ("aliases:\n  BEAT: [baton]", 2, "'baton': lexemes are written in capitals"),
        ("aliases:\n  BEAT: [BATON, BATON]", 2, "BATON is listed under BEAT already"),
        ("aliases:\n  BEAT:\n    - BEAT", 3, "BEAT has gestures of its own"),
        ("alias: 3", 1, "the key 'aliases' is missing"),
    ],
)
def test_wrong_aliases(tmp_path: Path, aliases: str, line: int, told: str) -> None:
    with pytest.raises(AuthoringError) as caught:
        library(tmp_path, gesture("CATEGORY BEAT"), aliases=aliases)
    assert caught.value.mistakes[0].line == line
    assert told in caught.value.mistakes[0].message


def test_a_name_that_no_gesture_has(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="did you mean 'trial'") as caught:
        library(tmp_path, gesture()).definition("trail")
    assert caught.value.code == "unknown_name"


def test_what_smartbody_asks_for_is_more_than_a_beat() -> None:
    """Its gesture types (shared/bml.md), those that our own lexemes go out as among them."""
    types = {*shipped_tables().gesture_map, "CENTER", "STOP"}
    found = load_gestures()
    assert {one for one in types if found.nearest(one) in {None, LAST_RESORT}} == set()


def test_every_alias_is_found_however_it_is_spelt() -> None:
    found = load_gestures()
    for lexeme, category in found.aliases.items():
        assert found.nearest(lexeme.lower().replace("_", "-")) == category


def test_a_manner_makes_every_gesture_larger_and_faster_and_leaves_the_library_as_it_is(tmp_path: Path) -> None:
    found = library(tmp_path, gesture("CATEGORY BEAT", name="one"))
    (plain,) = found.clips("BEAT", Level.MEDIUM, Hand.LEFT)
    (lively,) = found.in_manner(GestureManner(space=1.2, pace=1.25, elbow_deg=10)).clips(
        "BEAT", Level.MEDIUM, Hand.LEFT
    )
    assert lively.expressivity.amplitude == pytest.approx(1.2 * plain.expressivity.amplitude)
    assert lively.markers.end == pytest.approx(plain.markers.end / 1.25)
    assert lively.stroke_speed_m_s == pytest.approx(1.2 * 1.25 * plain.stroke_speed_m_s)
    assert lively.manner.elbow_deg == 10
    assert found.clips("BEAT", Level.MEDIUM, Hand.LEFT) == (plain,)
