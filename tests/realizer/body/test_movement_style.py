"""The file of how alive a body is: all mistakes at their places, and the one in use."""

from pathlib import Path

import pytest

from understudy.errors import AuthoringError
from understudy.files import resource_folder
from understudy.models import load_gestures
from understudy.realizer.body.movement_style import PLAIN, MovementStyle

IN_USE = resource_folder("lexicon") / "movement.yaml"


def test_the_file_in_use_keeps_what_people_do() -> None:
    """Issue 14, and 29 of the second hand, which stays before the belly; two hands 60 to 120 ms and 10 to 20 % apart,
    beats of 15 to 25 cm in holds over a second."""
    style = MovementStyle.load(IN_USE)
    assert style.second_hand.near_belly
    assert 0.2 <= style.second_hand.share[0] < style.second_hand.share[1] <= 0.5
    assert (style.two_hands.lag_s, style.two_hands.smaller) == ((0.06, 0.12), (0.1, 0.2))
    assert style.holds.longest_s <= 1.0
    assert style.holds.way_m == (0.15, 0.25)


def test_every_mistake_has_its_place(tmp_path: Path) -> None:
    file = tmp_path / "movement.yaml"
    text = IN_USE.read_text().replace("follows: ", "follow: ").replace("lag_s: [0.06, 0.12]", "lag_s: [0.12, 0.06]")
    file.write_text(text)
    with pytest.raises(AuthoringError) as caught:
        MovementStyle.load(file)
    places = {text.splitlines()[mistake.line - 1].strip().split(":")[0] for mistake in caught.value.mistakes}
    assert {"follow", "lag_s"} <= places


def test_gestures_that_are_named_must_be_in_the_library(tmp_path: Path) -> None:
    file = tmp_path / "movement.yaml"
    file.write_text(IN_USE.read_text().replace("[GREETING, FAREWELL]", "[GREETING, FARWELL]"))
    library = load_gestures()
    assert MovementStyle.load(IN_USE, library.categories) == MovementStyle.load(IN_USE)
    with pytest.raises(AuthoringError) as caught:
        MovementStyle.load(file, library.categories)
    (mistake,) = caught.value.mistakes
    assert "FARWELL" in mistake.source_line
    assert "did you mean 'FAREWELL'" in mistake.message


def test_without_a_file_nothing_is_added() -> None:
    assert PLAIN.second_hand.follows == 0
    assert PLAIN.stroke.dip_m == PLAIN.idle.bob_m == PLAIN.idle.neck_deg == 0
