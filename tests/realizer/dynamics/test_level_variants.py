"""Calm, usual and agitated gestures differ in silhouette, not in size alone."""

from itertools import combinations, product
from math import dist

import pytest

from understudy.model import Hand, Level, Side, Slots
from understudy.model.figure import Figure, GestureManner, Physique, Sex
from understudy.models import load_gestures, load_realizer
from understudy.realizer.arms.wrist_paths import stroke_end_m
from understudy.realizer.body.movement_style import MovementStyle
from understudy.realizer.dynamics.level_variants import varied
from understudy.realizer.dynamics.snapping import lifted
from understudy.realizer.gestures.gesture import HandShape
from understudy.realizer.gestures.gesture_plan import GestureRequest, PlacedGesture
from understudy.realizer.scheduling.selection import clips_of, place_clip

APART_M = 0.10


@pytest.fixture(scope="module")
def style() -> MovementStyle:
    return load_realizer().style


def of_sex(style: MovementStyle, sex: Sex) -> MovementStyle:
    return style.of(Figure(Physique(sex=sex)))


def request(category: str, level: Level, hand: Hand, slots: Slots | None = None) -> GestureRequest:
    return GestureRequest("", category, 1.0, 1.5, 1.0, hand, level, slots=slots)


def ended(placed: PlacedGesture) -> tuple[tuple[float, ...], tuple[HandShape, ...]]:
    """Where the hands are at the end of the stroke, and which shapes they had."""
    arms = [arm for key in placed.clip.keys for arm in (key.left, key.right) if arm is not None]
    places_m = tuple(float(part) for side in placed.arms for part in stroke_end_m(placed, side))
    return places_m, tuple(arm.hand for arm in arms if arm.hand is not None)


def made(category: str, hand: Hand, style: MovementStyle) -> dict[Level, list[PlacedGesture]]:
    found = {}
    for level in Level:
        asked = request(category, level, hand)
        plain = [place_clip(clip, asked) for clip in clips_of(asked, load_gestures())]
        found[level] = [varied(lifted(each, style.strokes), style.variants) for each in plain]
    return found


def test_the_commonest_gestures_have_variants(style: MovementStyle) -> None:
    assert len(style.variants) >= 30
    assert set(style.variants) <= set(load_gestures().categories)


def test_each_level_has_a_silhouette_of_its_own(style: MovementStyle) -> None:
    """The wrist at the end of the stroke is 10 cm elsewhere, or the hands have another shape; what points at something
    is aimed instead."""
    alike = []
    for category, hand in product(style.variants, (Hand.RIGHT, Hand.BOTH)):
        by_level = made(category, hand, style)
        for one, other in combinations(Level, 2):
            for first, second in zip(by_level[one], by_level[other], strict=True):
                (first_m, first_hands), (second_m, second_hands) = ended(first), ended(second)
                if not first.clip.aimed and dist(first_m, second_m) < APART_M and first_hands == second_hands:
                    alike.append((first.clip.name, one, other))
    assert alike == []


def test_what_shows_a_place_stays_where_it_is(style: MovementStyle) -> None:
    asked = request("PLACE_LEFT", Level.HIGH, Hand.RIGHT, Slots(height_m=1.0))
    (first, *_others) = (place_clip(clip, asked) for clip in clips_of(asked, load_gestures()))
    assert varied(first, style.variants) is first


def test_women_and_men_have_their_hands_elsewhere(style: MovementStyle) -> None:
    """At least 5 cm, which is seen; a neutral body has those of the library, and what shows a place stays there."""
    own = {sex: of_sex(style, sex) for sex in Sex}
    for category in style.variants:
        asked = request(category, Level.MEDIUM, Hand.RIGHT)
        plain = [place_clip(clip, asked) for clip in clips_of(asked, load_gestures())]
        for each in plain:
            made = {sex: varied(each, own[sex].variants) for sex in Sex}
            assert made[Sex.NEUTRAL] is each
            woman, man = (ended(made[sex]) for sex in (Sex.FEMALE, Sex.MALE))
            assert each.clip.aimed or dist(woman[0], man[0]) > 0.05
    shown = place_clip(plain[0].clip, request(category, Level.MEDIUM, Hand.RIGHT, Slots(side=Side.LEFT)))
    assert varied(shown, own[Sex.FEMALE].variants) is shown


def test_women_hold_their_elbows_in_and_men_out_within_what_was_tested(style: MovementStyle) -> None:
    elbows = {sex: style.sexes[sex].manner(GestureManner()).elbow_deg for sex in (Sex.FEMALE, Sex.MALE)}
    assert elbows[Sex.FEMALE] < 0 < elbows[Sex.MALE]
    assert style.sexes[Sex.FEMALE].manner(GestureManner(elbow_deg=-18)).elbow_deg == -20
    assert of_sex(style, Sex.FEMALE).idle.stance_weight > of_sex(style, Sex.MALE).idle.stance_weight
