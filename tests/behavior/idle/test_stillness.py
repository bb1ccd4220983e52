"""Stillness leaves out the least important first and makes the rest smaller; blinks and breath stay to the end."""

from itertools import pairwise
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.characters import CHARACTERS
from tests.support.words.by_hand import movement, offered, spoken, utterance
from understudy.behavior.choice.scheduling import schedule
from understudy.behavior.idle.stillness import stilled, with_stillness
from understudy.behavior.listeners.listening import HeadRates, Listener, listen
from understudy.errors import InputError
from understudy.model import Behavior, Channel, Listening, Performance, SyncPoints
from understudy.option_table import PERFORMANCE

LEXICON = Path(__file__).resolve().parents[3] / "lexicon"
RATES = HeadRates.load(LEXICON / "acting" / "head_rates.yaml")
LINE = utterance(spoken("We had it all. But you and I never said so, and now they go there again."), phrase_ends=(3, 9))
NAMES = ("gesture_me", "gesture_negation", "shake", "tilt_left", "smile", "gesture_surround", "big_nod")
SHARES = [number / 20 for number in range(21)]


def performed(seed: int) -> Performance:
    """Movements of several priorities on a line, with somebody who listens."""
    character = CHARACTERS.named("expansive")
    asked = [offered(movement(name, 2 * place, priority=1.0 + place)) for place, name in enumerate(NAMES)]
    behaviors = schedule(asked, LINE, character, seed=seed)
    heard = listen(behaviors, LINE, Listener(CHARACTERS.named("default"), RATES, "ada"), seed=seed)
    return Performance(LINE, (), behaviors, "ada", seed, listeners=(Listening("bob", heard),))


def kept(behaviors: tuple[Behavior, ...]) -> dict[str, Behavior]:
    return {each.id: each for each in behaviors if each.kept}


@given(st.integers(0, 200))
def test_the_stiller_the_fewer_and_the_smaller(seed: int) -> None:
    performance = performed(seed)
    by_share = [with_stillness(performance, share) for share in SHARES]
    for livelier, stiller in pairwise(by_share):
        pairs = [(livelier.behaviors, stiller.behaviors)]
        pairs.append((livelier.listeners[0].behaviors, stiller.listeners[0].behaviors))
        for more, less in pairs:
            assert kept(less).keys() <= kept(more).keys()
            for name, behavior in kept(less).items():
                assert (behavior.amount or 0.0) <= (kept(more)[name].amount or 0.0)
    assert by_share[0].behaviors == performance.behaviors
    assert len(kept(by_share[-1].behaviors)) < len(kept(performance.behaviors))


@given(st.integers(0, 200))
def test_at_one_only_blinks_and_breath_are_left_as_they_were(seed: int) -> None:
    performance = performed(seed)
    still = with_stillness(performance, 1.0)
    assert still.stillness == 1.0
    for before, after in [
        (performance.behaviors, still.behaviors),
        (performance.listeners[0].behaviors, still.listeners[0].behaviors),
    ]:
        left = kept(after)
        assert {each.lexeme for each in left.values()} <= {"BLINK", "OPEN_LIPS"}
        assert left == {name: each for name, each in kept(before).items() if name in left}
        blinks = {name for name, each in kept(before).items() if each.lexeme == "BLINK"}
        assert blinks <= left.keys()


def test_what_shows_nothing_goes_first_and_then_the_least_priority() -> None:
    sync = SyncPoints(0.0, 1.0)
    idle = Behavior("a", Channel.HEAD, "TILT_LEFT", sync, 0, 0, 0.0)
    minor = Behavior("b", Channel.GESTURE, "BEAT", sync, 0, 0, 2.0, function="f1", amount=0.5)
    major = Behavior("c", Channel.FACE, "RAISE_BROWS", sync, 0, 0, 3.0, function="f2", amount=0.8)
    third, half, two_thirds = (kept(stilled((major, idle, minor), share)) for share in (1 / 3, 0.5, 2 / 3))
    assert third.keys() == {"b", "c"}
    assert half.keys() == two_thirds.keys() == {"c"}
    assert half["c"].amount == pytest.approx(0.4)
    assert two_thirds["c"].amount == pytest.approx(0.8 / 3, abs=1e-3)
    [lost] = [each for each in stilled((major, idle, minor), 1 / 3) if not each.kept]
    assert "stillness" in (lost.reason or "")


def test_a_gesture_whose_size_nobody_said_is_smaller_too() -> None:
    one = Behavior("a", Channel.GESTURE, "BEAT", SyncPoints(0.0, 1.0), 0, 0, 0.0)
    [smaller] = stilled((one,), 0.4)
    assert smaller.amount == pytest.approx(0.3)


@pytest.mark.parametrize("wrong", [-0.01, 1.01, float("nan"), float("inf")])
def test_it_is_from_nothing_to_one(wrong: float) -> None:
    with pytest.raises(InputError) as caught:
        PERFORMANCE["stillness"].check(wrong)
    assert (caught.value.code, caught.value.field) == ("value_wrong", "stillness")
