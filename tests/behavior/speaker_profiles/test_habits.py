"""What of a profile is not gestures: how who speaks and who listens stands, rests and moves the head."""

from dataclasses import replace

import pytest

from tests.support.annotations import SPARING, SWEEPING
from understudy.behavior.listeners.listening import HeadRates
from understudy.behavior.speaker_profiles.habits import (
    HEAD_MOVEMENTS_PER_MINUTE,
    as_listener,
    listening_postures,
    speaking_postures,
)
from understudy.model import Behavior, Channel, Line
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.profiles.annotation.reading import read_annotations
from understudy.profiles.generation.script import RESTS, STANCES
from understudy.profiles.learning.learning import learn
from understudy.profiles.profile import HeadHabit, Profile, RestHabit
from understudy.realizer.scheduling.rests import POSTURES
from understudy.resources import resource_folder

RATES = HeadRates(nods_after_pause=0.3, nods_after_phrase=0.2, mirrored=0.6, delay_s=0.3, delay_spread_s=0.1)


@pytest.fixture(scope="module")
def profiles() -> tuple[Profile, Profile]:
    sweeping, sparing = read_annotations([SWEEPING, SPARING])
    return learn([sweeping], "sweeping"), learn([sparing], "sparing")


def _postured(profile: Profile, *postures: str) -> Profile:
    rests = RestHabit(near="open", medium="folded", far="in_pockets")
    return replace(profile, rests=rests, head=replace(profile.head, postures=postures))


def _lexemes(postures: list[Behavior]) -> list[str]:
    return [each.lexeme for each in postures]


def test_bodies_have_the_postures() -> None:
    assert {*RESTS.values(), *STANCES} <= POSTURES.keys()


def test_a_line_begins_in_the_commonest_postures_of_feet_and_hands(profiles: tuple[Profile, Profile]) -> None:
    slouching = _postured(profiles[0], "SLOUCHING", "HANDS_ON_HIPS", "WEIGHT_ON_RIGHT_LEG", "WEIGHT_ON_LEFT_LEG")
    assert _lexemes([*speaking_postures(slouching)]) == ["WEIGHT_ON_RIGHT_LEG", "HANDS_ON_HIPS"]
    assert [*speaking_postures(_postured(profiles[0]))] == []


@pytest.mark.parametrize(
    ("postures", "duration_s", "told"),
    [
        ((), 2.0, ["ARMS_OPEN"]),
        ((), 5.0, ["HANDS_FOLDED"]),
        (("WEIGHT_ON_LEFT_LEG",), 20.0, ["WEIGHT_ON_LEFT_LEG", "HANDS_IN_POCKETS"]),
        (("HANDS_ON_HIPS",), 20.0, ["HANDS_ON_HIPS"]),
    ],
)
def test_who_listens_rests_the_hands_as_long_as_the_line(
    profiles: tuple[Profile, Profile], postures: tuple[str, ...], duration_s: float, told: list[str]
) -> None:
    assert _lexemes([*listening_postures(_postured(profiles[0], *postures), duration_s)]) == told


def test_who_moves_the_head_much_nods_much(profiles: tuple[Profile, Profile]) -> None:
    def rates(**per_minute: float) -> HeadRates:
        return as_listener(RATES, replace(profiles[0], head=HeadHabit(per_minute=per_minute)))

    assert rates() == RATES
    assert rates(nod=HEAD_MOVEMENTS_PER_MINUTE) == RATES
    half = rates(nod=HEAD_MOVEMENTS_PER_MINUTE / 4, shake=HEAD_MOVEMENTS_PER_MINUTE / 4)
    assert (half.nods_after_pause, half.mirrored, half.delay_s) == (0.15, 0.3, RATES.delay_s)
    assert rates(nod=100.0).mirrored == 1.0


def test_each_listener_has_their_own_profile(understudy: Understudy, profiles: tuple[Profile, Profile]) -> None:
    folder = resource_folder("examples")
    line = Line((folder / "example.flac").read_bytes(), (folder / "example.txt").read_text())
    listening = (("ann", profiles[0]), ("ben", profiles[1]))
    performance = perform(understudy, line, Options(listeners=("ann", "ben", "eve"), listener_profiles=listening))
    ann, ben, eve = performance.listeners
    postures = [[each for each in heard.behaviors if each.kind is Channel.POSTURE] for heard in (ann, ben, eve)]
    assert list(map(_lexemes, postures)) == [["WEIGHT_ON_LEFT_LEG", "HANDS_AT_SIDE"], ["HANDS_FOLDED"], []]
    names = [each.id for each in ann.behaviors]
    assert len({*names}) == len(names)
