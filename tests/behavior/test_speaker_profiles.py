"""What of a profile is not gestures: how who speaks and who listens stands, rests and moves the head."""

from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from statistics import fmean

import pytest

from tests.support.annotations import SPARING, SWEEPING
from understudy.behavior.listeners.listening import HeadRates
from understudy.behavior.speaker_profiles import (
    HEAD_MOVEMENTS_PER_MINUTE,
    as_listener,
    listening_postures,
    speaking_postures,
)
from understudy.bml.writing.writer import write_bml
from understudy.errors import InputError
from understudy.files import resource_folder
from understudy.model import (
    Analysis,
    Avoidance,
    Behavior,
    Channel,
    DirectedMoment,
    Direction,
    Hand,
    Interval,
    Line,
    Mode,
    Performance,
    Word,
)
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform, perform_analysis, perform_line
from understudy.profiles.annotation.reading import read_annotations
from understudy.profiles.generation.script import RESTS, STANCES
from understudy.profiles.learning.learner import learn
from understudy.profiles.profile import HeadHabit, Profile, RestHabit
from understudy.realization import BmlInput, PreparedSchedule, prepare_schedule, realize_prepared
from understudy.realizer.scheduling.rests import POSTURES
from understudy.rules.stage import find_functions_in_all
from understudy.schemas.gestures.script import read_script, script_json

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


TEXT = "No, I told you that I have never seen so many people, and we all know it. What do you want from me?"
WORD_S = 0.35
NOTHING = Line(None, "")


@pytest.fixture(scope="module")
def analysis(understudy: Understudy) -> Analysis:
    words = tuple(
        Word(number, text, Interval(0.4 + WORD_S * number, 0.4 + WORD_S * (number + 1)))
        for number, text in enumerate(TEXT.split())
    )
    language = understudy.language
    [found] = find_functions_in_all(language, [words])
    return replace(found, utterance=replace(found.utterance, duration_s=0.8 + WORD_S * len(words)))


def _gestures(performance: Performance) -> list[Behavior]:
    return [each for each in performance.behaviors if each.kind is Channel.GESTURE and each.kept]


def test_the_hands_follow_the_profile_and_say_so(understudy: Understudy, analysis: Analysis) -> None:
    left = both = 0
    for seed in range(4):
        small = _gestures(perform_analysis(understudy, analysis, Options(profile="sparing", seed=seed)))
        large = _gestures(perform_analysis(understudy, analysis, Options(profile="sweeping", seed=seed)))
        assert {each.rule for each in small} == {"profile_sparing"}
        assert {each.rule for each in large} == {"profile_sweeping"}
        left += sum(each.hand is Hand.LEFT for each in small) - sum(each.hand is Hand.LEFT for each in large)
        both += sum(each.hand is Hand.BOTH for each in large) - sum(each.hand is Hand.BOTH for each in small)
        assert fmean(each.amount or 0 for each in small) < fmean(each.amount or 0 for each in large)
        functions = {each.id for each in analysis.functions}
        assert all(each.function in functions for each in (*small, *large))
    assert left > 0
    assert both > 0


def test_nothing_overlaps_on_a_hand_or_among_postures(understudy: Understudy, analysis: Analysis) -> None:
    for seed in range(4):
        behaviors = perform_analysis(understudy, analysis, Options(profile="sweeping", seed=seed)).behaviors
        for channel in (Channel.GESTURE, Channel.POSTURE):
            kept = sorted(
                (each for each in behaviors if each.kept and each.kind is channel), key=lambda each: each.sync.start
            )
            for one, other in pairwise(kept):
                assert one.sync.end <= other.sync.start + 1e-9, (one, other)


def test_what_a_director_avoids_is_not_made_and_what_he_asks_for_is(understudy: Understudy, analysis: Analysis) -> None:
    still = Direction(avoid=(Avoidance(0, 10, ("hands",)),))
    asked = Direction(moments=(DirectedMoment(6, 7, 7, 3, gesture=("negation",)),), complete=True)
    for seed in range(3):
        options = Options(profile="sweeping", seed=seed)
        first_s = min(
            (each.sync.stroke_start or 0 for each in _gestures(perform_analysis(understudy, analysis, options, still))),
            default=99.0,
        )
        assert first_s > 0.4 + 11 * WORD_S - 1.0
        [made] = _gestures(perform_analysis(understudy, analysis, options, asked))
        assert (made.moment is not None, made.rule != "profile_sweeping") == (True, True)


def test_heads_and_eyes_follow_too(understudy: Understudy, analysis: Analysis) -> None:
    def heads(profile: str) -> int:
        behaviors = perform_analysis(understudy, analysis, Options(profile=profile)).behaviors
        return sum(each.kind is Channel.HEAD and each.kept and bool(each.moment) for each in behaviors)

    assert heads("sparing") <= heads("sweeping")


def test_without_a_profile_there_is_no_script(understudy: Understudy, analysis: Analysis) -> None:
    with pytest.raises(InputError, match="name one"):
        perform_line(understudy, NOTHING, Options(), analysis=analysis).written_script()
    with pytest.raises(InputError, match="there is no profile 'sweepin'; did you mean 'sweeping'"):
        perform_analysis(understudy, analysis, Options(profile="sweepin"))
    with pytest.raises(InputError, match="mode prosody"):
        Options(profile="sweeping", mode=Mode.PROSODY)


def test_script_and_bml_are_played_as_performed(understudy: Understudy, analysis: Analysis) -> None:
    performed = perform_line(understudy, NOTHING, Options(profile="sweeping", seed=2), analysis=analysis)
    performance, script = performed.performance, performed.written_script()
    read = read_script(script_json(script, performance.utterance, performance.character))
    wanted = {each.id: each for each in _gestures(performance)}
    assert len(_gestures(read)) == len(wanted) == len(script.made)
    for one, other in zip(_gestures(read), wanted.values(), strict=True):
        assert (one.lexeme, one.hand, one.after_strokes_s) == (other.lexeme, other.hand, other.after_strokes_s)
        assert one.curved == other.curved
        assert [time_s for _name, time_s in one.sync.in_order()] == pytest.approx(
            [time_s for _name, time_s in other.sync.in_order()], abs=0.002
        )
    played = realize_prepared(understudy.realizer, PreparedSchedule.of(read))
    assert not [each for each in played.motion.notices if each.code == "gesture_not_played"]
    bml = write_bml(performance)
    again = prepare_schedule(None, BmlInput(bml, Path("x.bml")))
    gestures = [each for each in again.schedule.behaviors if each.kind is Channel.GESTURE]
    assert {each.id: each.after_strokes_s for each in gestures} == {
        name: each.after_strokes_s for name, each in wanted.items()
    }
    assert (
        {each.id for each in gestures if each.curved} == {name for name, each in wanted.items() if each.curved} != set()
    )


def test_a_script_that_is_wrong_is_told() -> None:
    with pytest.raises(InputError, match="duration_s"):
        read_script(b'{"profile": "x", "gestures": []}')
    with pytest.raises(InputError, match="a unit has g9"):
        read_script(
            b'{"profile": "x", "duration_s": 1, "gestures": [], '
            b'"units": [{"start_s": 0, "end_s": 1, "gestures": ["g9"], "rest": "open"}]}'
        )
    with pytest.raises(InputError, match="not JSON"):
        read_script(b"{")
