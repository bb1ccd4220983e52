"""The gestures that we ship (lexicon/gestures/): what the rules and the characters ask for is there, at every level and
by every hand that it is asked of, and no key pose asks an arm for what it cannot do.
"""

from collections.abc import Iterator
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from understudy.behavior.characters.overlays import Characters
from understudy.behavior.table.behavior_table import BehaviorEntry
from understudy.model import Channel, FloatArray, Hand, Level
from understudy.realizer.body.contacts import penetrations_m
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.gestures.gesture import ArmKey, Clip, Definition, FrameType
from understudy.realizer.gestures.gesture_space import sector_m
from understudy.realizer.gestures.library import Library, clip
from understudy.realizer.pictures.gesture_sheet import key_poses
from understudy.realizer.scheduling.selection import TOLERANCE_S

ROOT = Path(__file__).resolve().parents[2]
LEXICON = ROOT / "lexicon"
PAGE = ROOT / "docs" / "gestures.md"

TOUCHING = {"PALMS_TOGETHER", "MIME_CLAP", "MIME_HUG", "MIME_RUB_HANDS"}
"""Categories whose hands meet on purpose."""

CHEST_M = 0.13
"""How far before the hips' axis the chest's front is."""

COMMON = ("BEAT", "RHYTHM", "PALM_BEAT", "QUESTION", "NEGATION", "ME", "UNCERTAINTY", "SHRUG", "CONTRAST", "SURROUND")


@pytest.fixture(scope="module")
def library() -> Library:
    return Library.load(LEXICON / "gestures")


def entries() -> Iterator[BehaviorEntry]:
    """Every gesture that a rule may choose, as every character makes it."""
    for character in Characters.load(LEXICON).by_name.values():
        for entry in character.entries.values():
            if entry.channel is Channel.GESTURE:
                yield entry


def hands_asked(entry: BehaviorEntry) -> tuple[Hand, ...]:
    return (entry.hand,) if entry.hand else (Hand.LEFT, Hand.RIGHT)


def made(library: Library) -> Iterator[Clip]:
    """Every definition at every level, by the hands it is for."""
    for definition, level in product(library.definitions, Level):
        if level in definition.levels:
            yield clip(definition, level, definition.hand or Hand.RIGHT, definition.categories[0])


def wrists_m(found: Clip) -> Iterator[tuple[FloatArray, ...]]:
    """At each key that says where all its arms are: the wrists, the left's x outwards, the right's mirrored."""
    for key in found.keys:
        arms: list[ArmKey] = [arm for arm in (key.left, key.right) if arm is not None]
        places = [arm.place for arm in arms]
        if all(place is not None for place in places):
            yield tuple(sector_m(place, found.expressivity.amplitude) for place in places if place is not None)


def test_every_gesture_asked_for_is_there_by_the_hands_it_is_asked_of(library: Library) -> None:
    definitions = {definition.name: definition for definition in library.definitions}
    for entry in entries():
        for hand, level in product(hands_asked(entry), Level):
            clips = library.clips(entry.lexeme, level, hand)
            assert clips, (entry.lexeme, level, hand)
            own = {None, hand} if hand is not Hand.BOTH else {Hand.BOTH}
            assert {definitions[one.name].hand for one in clips} <= own, (entry.lexeme, hand)


def test_every_category_has_variants(library: Library) -> None:
    lexemes = {entry.lexeme for entry in entries()}
    assert len(lexemes) > 100
    assert {lexeme for lexeme in lexemes if len(library.by_category[lexeme]) < 2} == set()


@pytest.mark.parametrize("category", COMMON)
def test_common_categories_have_variants_by_the_same_hands(library: Library, category: str) -> None:
    asked = {hand for entry in entries() if entry.lexeme == category for hand in hands_asked(entry)}
    assert asked
    for hand, level in product(asked, Level):
        assert len(library.clips(category, level, hand)) >= 2


def test_the_more_agitated_the_faster(library: Library) -> None:
    for definition in library.definitions:
        clips = [clip(definition, level, definition.hand or Hand.RIGHT, "X") for level in Level]
        low, medium, high = (one.stroke_speed_m_s for one in clips)
        assert 0 < low < medium < high, definition.name


def test_some_variant_s_stroke_is_about_as_long_as_the_table_says(library: Library) -> None:
    """A little longer is allowed: people's strokes are (shared/motion.md), and the preparation gives way."""
    for entry in entries():
        stroke = entry.timing.stroke
        assert stroke is not None
        for hand in hands_asked(entry):
            marks = [found.markers for found in library.clips(entry.lexeme, Level.MEDIUM, hand)]
            durations_s = [mark.stroke_end - mark.stroke_start for mark in marks]
            fit = [stroke.shortest_s - 0.02 <= duration_s <= 1.15 * stroke.usual_s for duration_s in durations_s]
            assert any(fit), (entry.lexeme, durations_s)


def test_some_variant_fits_a_stroke_of_usual_length_with_the_shortest_hold(library: Library) -> None:
    """Paper §3.8, eq. 5, as forgivingly as clips are chosen, with the point of emphasis at .61 of the stroke, as the
    schedule has it."""
    for entry in entries():
        stroke, hold = entry.timing.stroke, entry.timing.hold
        assert stroke is not None
        room_s = (1 - 0.61) * stroke.usual_s + hold.shortest_s + TOLERANCE_S
        for hand, level in product(hands_asked(entry), Level):
            marks = [found.markers for found in library.clips(entry.lexeme, level, hand)]
            assert min(mark.relax - mark.stroke for mark in marks) <= room_s, (entry.lexeme, level)


def test_no_wrist_is_out_of_reach(library: Library) -> None:
    """An arm is .53 m long; the last centimetre is left to be eased into."""
    skeleton = Skeleton.standing()
    shoulder_m = np.sum(skeleton.offsets_m[skeleton.chain("spine", "chest", "upperChest")], axis=0)
    shoulder_m = shoulder_m + np.sum(skeleton.offsets_m[skeleton.chain("leftShoulder", "leftUpperArm")], axis=0)
    for found in made(library):
        for wrists in wrists_m(found):
            assert max(np.linalg.norm(wrist - shoulder_m) for wrist in wrists) <= 0.54, found.name


def test_no_wrist_is_in_the_body(library: Library) -> None:
    for found in made(library):
        for wrists in wrists_m(found):
            for outwards, _up, away in wrists:
                assert away >= CHEST_M or outwards >= 0.2, (found.name, found.level)


def test_no_hand_or_forearm_is_in_the_body_where_the_stroke_ends(library: Library) -> None:
    """A centimetre or two beside the belly is left to `collisions.clear`, which works on the whole motion."""
    skeleton = Skeleton.standing()
    for definition in library.definitions:
        found = clip(definition, Level.MEDIUM, definition.hand or Hand.RIGHT, definition.categories[0])
        poses = [pose for pose in key_poses(skeleton, found) if pose.key.type is FrameType.STROKE_END]
        rotations = np.array([pose.rotations for pose in poses])
        hips_m = np.broadcast_to(skeleton.offsets_m[0], (len(poses), 3))
        assert penetrations_m(skeleton, rotations, hips_m).max() < 0.02, found.name


def test_two_hands_stay_apart(library: Library) -> None:
    definitions: dict[str, Definition] = {definition.name: definition for definition in library.definitions}
    for found in made(library):
        least_m = 0.04 if TOUCHING & set(definitions[found.name].categories) else 0.12
        for left, *right in wrists_m(found):
            for other in right:
                assert np.linalg.norm(left - other * [-1, 1, 1]) >= least_m, (found.name, found.level)


def test_the_page_lists_every_gesture_by_category_and_hands(library: Library) -> None:
    rows = [line.split("|")[1:-1] for line in PAGE.read_text(encoding="utf-8").splitlines() if line.startswith("| ")]
    listed = {row[0].strip(): tuple(names(cell) for cell in row[2:]) for row in rows if row[0].strip() != "category"}
    there = {category: by_hands(definitions) for category, definitions in library.by_category.items()}
    del there["SMALL"]
    assert listed == there
    assert all(row[1].strip() for row in rows)


def names(cell: str) -> tuple[str, ...]:
    return tuple(sorted(filter(None, (name.strip(" `") for name in cell.split(",")))))


def by_hands(definitions: tuple[Definition, ...]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The names of one-handed gestures, and of two-handed ones."""
    one = sorted(each.name for each in definitions if each.hand is not Hand.BOTH)
    both = sorted(each.name for each in definitions if each.hand is Hand.BOTH)
    return tuple(one), tuple(both)
