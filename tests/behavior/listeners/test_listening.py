"""Where listeners are, and whom the speaker addresses."""

from itertools import combinations, pairwise
from math import atan2, degrees, dist
from pathlib import Path

import pytest

from tests.support.characters import CHARACTERS
from tests.support.words.by_hand import movement, offered, spoken, utterance
from understudy.behavior.characters.overlays import Character
from understudy.behavior.choice.scheduling import schedule
from understudy.behavior.listeners.listening import (
    DISTANCE_M,
    ELBOW_ROOM_M,
    HeadRates,
    Listener,
    addressed,
    listen,
    placed_listeners,
)
from understudy.behavior.reading.player import Ban
from understudy.errors import AuthoringError
from understudy.model import Behavior, Channel, Interval, SyncPoints, Target, Word

ANNA = Target("anna", (-0.8, 1.6, 1.0))


def gaze(name: str, start_s: float, lexeme: str = "LOOK", target: str = "listener") -> Behavior:
    return Behavior(name, Channel.GAZE, lexeme, SyncPoints(start_s, start_s + 0.5), 0, 0, 0.0, target=target)


def test_one_listener_needs_no_place_unless_the_scene_gives_one() -> None:
    assert placed_listeners(["ben"], []) == ()
    assert placed_listeners(["anna"], [ANNA]) == (ANNA,)


@pytest.mark.parametrize("count", [2, 3, 5, 16])
def test_several_stand_in_an_arc_before_the_speaker_and_do_not_touch(count: int) -> None:
    placed = placed_listeners([f"l{number}" for number in range(count)], [])
    places_m = [target.position_m for target in placed]
    assert all(dist((x, z), (0, 0)) > DISTANCE_M - 0.01 and z > 0 for x, _y, z in places_m)
    assert min(dist(one, other) for one, other in combinations(places_m, 2)) > ELBOW_ROOM_M - 0.01
    angles = [degrees(atan2(x, z)) for x, _y, z in places_m]
    assert angles == sorted(angles, reverse=True), "the first on the speaker's left"
    assert sum(angles) == pytest.approx(0.0, abs=0.5)
    assert max(angles) <= 60.1


def test_who_has_a_place_keeps_it() -> None:
    placed = {target.name: target.position_m for target in placed_listeners(["ben", "anna", "cleo"], [ANNA])}
    assert placed["anna"] == ANNA.position_m
    assert placed["ben"][0] > 0 > placed["cleo"][0]


def test_looks_and_gestures_at_the_listener_go_to_whom_the_speaker_turned_to() -> None:
    you = Behavior("you", Channel.GESTURE, "YOU", SyncPoints(3.2, 3.9), 0, 0, 1.0)
    beat = Behavior("beat", Channel.GESTURE, "BEAT", SyncPoints(4.2, 4.9), 0, 0, 1.0)
    behaviors = (
        gaze("opening", 0.0, "SHIFT"),
        gaze("aside", 1.0),
        gaze("turn", 3.0, "SHIFT"),
        you,
        beat,
        gaze("door", 5.0, target="door"),
        gaze("again", 6.0, "SHIFT"),
    )
    names = ["anna", "ben"]
    targets = placed_listeners(names, [ANNA])
    found = {each.id: each.target for each in addressed(behaviors, names, targets)}
    assert found == {
        "opening": "anna",
        "aside": "anna",
        "turn": "ben",
        "you": "ben",
        "beat": None,
        "door": "door",
        "again": "anna",
    }
    assert addressed(behaviors, ["ben"], ()) == behaviors, "an only listener is just that"


LEXICON = Path(__file__).resolve().parents[3] / "lexicon"
RATES = HeadRates.load(LEXICON / "acting" / "head_rates.yaml")

EAGER = HeadRates(nods_after_pause=1.0, nods_after_phrase=1.0, mirrored=1.0, delay_s=0.4, delay_spread_s=0.0)
"""A listener who leaves nothing unanswered."""

DEFAULT = CHARACTERS.named("default")
WORDS = spoken(" ".join([*["word"] * 20, "word,", *["word"] * 39]))
LINE = utterance(WORDS)
SPOKEN = schedule([offered(movement("tilt_left", 10)), offered(movement("gesture_me", 30))], LINE, DEFAULT, seed=0)


def heard(listener: Character = DEFAULT, seed: int = 0, rates: HeadRates = EAGER) -> list[Behavior]:
    return list(listen(SPOKEN, LINE, Listener(listener, rates, "ada"), seed=seed))


def test_the_head_is_mirrored_after_half_a_second() -> None:
    (spoken_tilt,) = (behavior for behavior in SPOKEN if behavior.function and behavior.kind is Channel.HEAD)
    (mirrored,) = (behavior for behavior in heard() if "mirrors" in (behavior.reason or ""))
    assert (mirrored.lexeme, spoken_tilt.lexeme) == ("TILT_RIGHT", "TILT_LEFT")
    for (name, at_s), (_, spoken_s) in zip(mirrored.sync.in_order(), spoken_tilt.sync.in_order(), strict=True):
        assert at_s == pytest.approx(spoken_s + 0.5), name
    assert (mirrored.amount or 0) < (spoken_tilt.amount or 0)


def test_a_listener_never_does_what_its_character_never_does() -> None:
    never = Ban(0, 99, frozenset({"small_nod", "tilt_right", "blink"}), "never")
    found = listen(SPOKEN, LINE, Listener(DEFAULT, EAGER, "ada", (never,)), seed=0)
    asked = [each for each in found if each.kind is Channel.HEAD and "still" not in (each.reason or "")]
    assert asked == []
    assert not [each for each in found if each.kind is Channel.EYES]


def test_a_listener_keeps_the_hands_still_and_the_eyes_on_the_speaker() -> None:
    behaviors = heard()
    assert {behavior.kind for behavior in behaviors if behavior.kept} == {Channel.HEAD, Channel.GAZE, Channel.EYES}
    gazes = [behavior for behavior in behaviors if behavior.kind is Channel.GAZE]
    assert {gaze.target for gaze in gazes} == {"ada"}
    aside_s = sum(gaze.sync.end - gaze.sync.start for gaze in gazes if gaze.direction)
    assert aside_s < 0.6 * 24


def test_a_listener_nods_at_phrase_ends_and_pauses() -> None:
    (nod,) = (behavior for behavior in heard() if "phrase ends" in (behavior.reason or "") and behavior.lexeme == "NOD")
    assert (nod.first, nod.lexeme) == (20, "NOD")
    assert nod.sync.start > (WORDS[20].interval or Interval(0, 0)).end_s
    words = tuple(Word(index, "word", Interval(index * 3.0, index * 3.0 + 1)) for index in range(5))
    paused = listen((), utterance(words), Listener(DEFAULT, EAGER, "ada"), seed=0)
    assert len([each for each in paused if each.reason == "nods as the speaker pauses"]) == 4


def nods_at_pauses(rates: HeadRates, seed: int) -> tuple[int, int]:
    """The nods at the pauses of a long line, and how many pauses there are."""
    words = tuple(Word(index, f"word{seed}", Interval(index * 3.0, index * 3.0 + 1)) for index in range(101))
    behaviors = listen((), utterance(words), Listener(DEFAULT, rates, "ada"), seed=seed)
    return sum(each.reason == "nods as the speaker pauses" and each.kept for each in behaviors), 100


def test_people_leave_most_pauses_and_movements_without_an_answer() -> None:
    counts = [nods_at_pauses(RATES, seed) for seed in range(20)]
    share = sum(nods for nods, _ in counts) / sum(pauses for _, pauses in counts)
    assert share == pytest.approx(RATES.nods_after_pause, abs=0.04)
    assert RATES.nods_after_phrase < RATES.nods_after_pause < 0.5
    answered = sum("mirrors" in (each.reason or "") for seed in range(100) for each in heard(seed=seed, rates=RATES))
    assert answered / 100 == pytest.approx(RATES.mirrored, abs=0.06)


def test_nothing_overlaps_and_every_id_is_one() -> None:
    behaviors = heard()
    assert len({behavior.id for behavior in behaviors}) == len(behaviors)
    for channel in Channel:
        in_time = [behavior.sync for behavior in behaviors if behavior.kept and behavior.kind is channel]
        assert all(one.end <= other.start for one, other in pairwise(in_time))
    assert all(behavior.rule is None and behavior.function is None for behavior in behaviors)


def test_listeners_differ_and_each_is_the_same_again() -> None:
    reserved = CHARACTERS.named("reserved")
    assert heard() == heard()
    assert heard() != heard(reserved) != heard(reserved, seed=1)


def test_without_times_there_is_nothing_to_listen_to() -> None:
    assert listen((), utterance((Word(0, "Yes."),)), Listener(DEFAULT, RATES, "ada"), seed=0) == ()


GOOD = """\
nods_after_pause: 0.2
nods_after_phrase: 0.1
mirrored: 0
delay_s: 0.5
delay_spread_s: 0.3
"""


def test_rates_are_read(tmp_path: Path) -> None:
    (tmp_path / "head_rates.yaml").write_text(GOOD, encoding="utf-8")
    assert HeadRates.load(tmp_path / "head_rates.yaml") == HeadRates(0.2, 0.1, 0.0, 0.5, 0.3)


def test_every_mistake_is_told_with_its_line(tmp_path: Path) -> None:
    wrong = GOOD.replace("0.2", "1.2").replace("delay_s: 0.5", "delay_s: soon").replace("mirrored", "mirored")
    (tmp_path / "head_rates.yaml").write_text(wrong, encoding="utf-8")
    with pytest.raises(AuthoringError) as caught:
        HeadRates.load(tmp_path / "head_rates.yaml")
    assert {mistake.line for mistake in caught.value.mistakes} >= {1, 3, 4}
