"""The valid combinations of the gesture language, as given to tools: exactly those that the checker accepts."""

from itertools import product

from tests.support.motion.gesture_files import gesture
from understudy.authoring.gesture_texts import check_text
from understudy.realizer.body.skeleton import Skeleton
from understudy.schemas.gestures.language import GestureLanguageResponse

BODY = Skeleton.standing()
TOLD = GestureLanguageResponse.of(BODY)


def is_right(line: str) -> bool:
    return not check_text(gesture(last=f"FRAMETYPE stroke_end\n  {line}"), BODY).mistakes


def test_palm_up_leaves_the_four_directions_of_the_paper() -> None:
    """Gesture Engine §4.3: away, inwards, outwards or towards."""
    orientations = TOLD.orientations
    [up] = [one for one in orientations if one.directions == ["Up"]]
    single = {orientations[number].directions[0] for number in up.partners if len(orientations[number].directions) == 1}
    assert single == {"Away", "Inwards", "Outwards", "Towards"}


def test_the_checker_passes_the_pairs_of_directions_that_are_told_and_no_other() -> None:
    names = ["".join(one.directions) or "Default" for one in TOLD.orientations]
    for (number, one), (other, name) in product(enumerate(TOLD.orientations), enumerate(names)):
        assert is_right(f"WRIST FB{names[number]} Palm{name}") == (other in one.partners), (names[number], name)


def test_the_checker_passes_the_thumbs_that_are_told_and_no_other() -> None:
    for form, thumb in product(TOLD.forms, ("open", "out", "across")):
        assert is_right(f"HAND {form.name}_{thumb}") == (thumb in form.thumbs)


def test_sectors_out_of_reach_are_those_that_the_checker_doubts() -> None:
    """At medium agitation, whose gestures are as large as they are written."""
    for x, y, z in product(TOLD.x, TOLD.y, TOLD.z):
        place = (x.name, y.name, z.name)
        text = gesture("LEVELS medium", last=f"FRAMETYPE stroke_end\n  ARM {' '.join(place)}")
        assert bool(check_text(text, BODY).doubts) == (place in TOLD.out_of_reach), place


def test_the_checker_passes_the_tracks_that_are_told_and_none_beyond() -> None:
    most, turns = TOLD.ranges["track_degrees"][1], TOLD.ranges["track_turns"]
    for form, joint in product(TOLD.track_forms, TOLD.track_joints):
        for degrees, turned in product((most, most + 1), turns):
            last = f" {turned}" if form == "circling" else ""
            track = f"TRACK {form} {joint} 0 {degrees:g} 0{last}"
            assert (not check_text(gesture(track), BODY).mistakes) == (degrees == most), track
