"""A stream from its first chunk to its end: voice, words, silence, listening, interruption, frames."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from tests.acoustic.pitch.test_streaming import LINE
from tests.live.kept import grown, kept
from tests.live.streams import CHUNK, behaviors, frames, heard
from understudy.errors import InputError
from understudy.live.messages import BehaviorMessage, LiveMessage, LiveOptions, MouthMessage, WithdrawalMessage
from understudy.live.models import LiveModels
from understudy.live.session import LONGEST_SILENCE_S, MOST_WAITING, LiveSession
from understudy.live.words import TimedText
from understudy.model import SAMPLE_RATE_HZ, Channel, Interval
from understudy.realizer.geometry.rotations import angle_between

WORDS = ["No,", "I", "have", "never", "seen", "those", "two", "big", "boats", "before."]
FRAMES = LiveOptions(frame_rate_hz=30)
INTERRUPTED_S = 2.0
STOPS_WITHIN_S = 0.15
KEPT_TIMES = 12
LONGEST_AFTER_S = 1.2
"""After the last sound: what is held ahead, and a hand's way back."""


def timed(begin_s: float) -> tuple[TimedText, ...]:
    return tuple(TimedText(word, Interval(begin_s + 0.3 * k, begin_s + 0.3 * k + 0.28)) for k, word in enumerate(WORDS))


def test_a_voice_moves_hands_head_eyes_and_mouth(models: LiveModels) -> None:
    told = [each for _, each in heard(LiveSession(models, LiveOptions()))]
    assert {each.kind for each in behaviors(told)} >= {Channel.GESTURE, Channel.EYES}
    assert any(isinstance(each, MouthMessage) for each in told)
    assert not frames(told)


def test_a_voice_moves_nothing_that_the_character_never_shows(models: LiveModels) -> None:
    behavior = models.understudy.behavior
    quiet = replace(behavior.characters.named("default"), name="quiet", never={"hands": None, "eyes": None})
    characters = replace(behavior.characters, by_name={**behavior.characters.by_name, "quiet": quiet})
    understudy = replace(models.understudy, behavior=replace(behavior, characters=characters))
    session = LiveSession(replace(models, understudy=understudy), LiveOptions(character="quiet"))
    told = [each for _, each in heard(session)]
    assert any(isinstance(each, MouthMessage) for each in told)
    assert not {each.kind for each in behaviors(told)} & {Channel.GESTURE, Channel.EYES}


def test_nothing_is_told_of_the_past(models: LiveModels) -> None:
    """What is begun begins when it is told, or later."""
    for now_s, told in heard(LiveSession(models, LiveOptions())):
        if isinstance(told, BehaviorMessage) and not told.revised:
            assert told.behavior.sync.start >= now_s - 1e-3
            assert told.heard_s == now_s


def test_what_is_held_is_never_told_to_relax_sooner_and_nothing_goes_on_for_long_after_the_sound(
    models: LiveModels,
) -> None:
    session = LiveSession(models, LiveOptions())
    told = behaviors([each for _, each in heard(session)])
    for name in {each.id for each in told}:
        reliefs_s = [each.sync.relax for each in told if each.id == name and each.sync.relax is not None]
        assert reliefs_s == sorted(reliefs_s), name
    assert max(each.sync.end for each in told) < session.heard_s + LONGEST_AFTER_S


def test_the_same_stream_tells_the_same_and_another_seed_something_else(models: LiveModels) -> None:
    one, again, other = ([each for _, each in heard(LiveSession(models, LiveOptions(seed=seed)))] for seed in (1, 1, 2))
    assert one == again
    assert one != other


def test_words_take_over(models: LiveModels) -> None:
    """Their behaviours come with rules at once; while they are spoken the voice begins nothing."""
    session = LiveSession(models, LiveOptions())
    coming = behaviors(list(session.words(timed(0.5))))
    assert any(each.rule for each in coming)
    assert {each.lexeme for each in coming} & {"SHAKE", "NEGATION"}
    while_spoken = [
        each.behavior
        for now_s, each in heard(session)
        if isinstance(each, BehaviorMessage) and 0.5 < now_s < 0.5 + 0.3 * len(WORDS) and not each.revised
    ]
    assert not while_spoken


def test_what_words_promised_stays_when_more_words_come(models: LiveModels) -> None:
    session = LiveSession(models, LiveOptions())
    first = {each.id for each in behaviors(list(session.words(timed(0.5))))}
    told = session.words(timed(0.5 + 0.3 * len(WORDS)))
    assert not {each.id for each in told if isinstance(each, WithdrawalMessage)} & first
    assert not {each.id for each in behaviors(list(told))} & first


def test_plain_text_waits_for_its_voice(models: LiveModels) -> None:
    session = LiveSession(models, LiveOptions())
    assert session.text(" ".join(WORDS)) == ()
    assert not any(each.rule for each in behaviors(list(session.silence(1.0))))
    assert any(each.rule for each in behaviors([told for _, told in heard(session)]))


def test_only_so_many_texts_wait(models: LiveModels) -> None:
    session = LiveSession(models, LiveOptions())
    for _ in range(MOST_WAITING):
        session.text("yes")
    with pytest.raises(InputError) as raised:
        session.text("yes")
    assert raised.value.code == "words_waiting"


@pytest.mark.parametrize(
    "words",
    [
        (TimedText("two words", Interval(0.0, 1.0)),),
        (TimedText("far", Interval(500.0, 501.0)),),
        (TimedText("one", Interval(0.0, 1.0)), TimedText("two", Interval(0.5, 1.5))),
    ],
)
def test_words_that_cannot_be_are_refused_and_the_stream_goes_on(
    models: LiveModels, words: tuple[TimedText, ...]
) -> None:
    session = LiveSession(models, LiveOptions())
    with pytest.raises(InputError) as raised:
        session.words(words)
    assert (raised.value.code, raised.value.field) == ("value_wrong", "words")
    assert session.words(timed(0.5))


@pytest.mark.parametrize("duration_s", [-0.1, LONGEST_SILENCE_S + 0.1, float("nan")])
def test_silences_that_cannot_be_are_refused(models: LiveModels, duration_s: float) -> None:
    with pytest.raises(InputError):
        LiveSession(models, LiveOptions()).silence(duration_s)


def test_a_listener_looks_at_who_talks_and_does_not_gesture(models: LiveModels) -> None:
    session = LiveSession(models, LiveOptions())
    told: list[LiveMessage] = []
    for first in range(0, len(LINE), CHUNK):
        told += session.hear(None, LINE[first : first + CHUNK])
    kinds = {each.kind for each in behaviors(told)}
    assert Channel.GAZE in kinds
    assert Channel.GESTURE not in kinds
    assert session.heard_s == pytest.approx(len(LINE) / SAMPLE_RATE_HZ)


def test_a_listener_nods_now_and_then(models: LiveModels) -> None:
    """Where the other pauses: a short phrase and half a second of silence, twenty times."""
    session, nods = LiveSession(models, LiveOptions()), 0
    phrase, pause = LINE[: round(0.7 * SAMPLE_RATE_HZ)], np.zeros(SAMPLE_RATE_HZ // 2)
    for _ in range(20):
        told = [*session.hear(None, phrase), *session.hear(None, pause)]
        nods += sum(each.kind is Channel.HEAD for each in behaviors(told))
    assert 1 <= nods <= 10


def test_an_interruption_stops_everything_and_goes_to_rest_without_a_jump(models: LiveModels) -> None:
    session = LiveSession(models, FRAMES)
    promised = {each.id for each in behaviors(list(session.words(timed(0.6))))}
    before = frames(list(session.silence(INTERRUPTED_S)))
    withdrawn = {each.id for each in session.interrupt() if isinstance(each, WithdrawalMessage)}
    assert withdrawn
    assert withdrawn <= promised
    after = frames(list(session.silence(4.0)))
    assert not any(each.kind is Channel.GESTURE for each in session._agenda.behaviors)
    poses = np.stack([each.rotations for each in [*before, *after]])
    steps = angle_between(poses[1:], poses[:-1]).max(axis=-1)
    arms = [models.understudy.realizer.skeleton.names.index(name) for name in ("rightUpperArm", "rightLowerArm")]
    to_rest = angle_between(poses[:, arms], poses[-1, arms]).max(axis=-1)
    interrupted = len(before) - 1
    assert to_rest[interrupted] > np.radians(15)
    assert to_rest[interrupted + 30] < np.radians(6)
    assert (np.diff(to_rest[interrupted + round(30 * STOPS_WITHIN_S) : interrupted + 20]) <= np.radians(0.5)).all()
    assert steps[interrupted - 1 : interrupted + 30].max() < 2 * steps[: interrupted - 1].max()


def test_frames_come_once_each_and_in_time(models: LiveModels) -> None:
    session, told = LiveSession(models, FRAMES), list[LiveMessage]()
    for now_s, each in heard(session, LINE[: 3 * SAMPLE_RATE_HZ]):
        told.append(each)
        assert not isinstance(each, MouthMessage) or each.heard_s == now_s
    times_s = [each.at_s for each in frames(told)]
    assert times_s[0] == 0.0
    assert all(other - one == pytest.approx(1 / 30) for one, other in pairwise(times_s))
    assert times_s[-1] == pytest.approx(session.heard_s, abs=1 / 30)


def test_no_character_of_this_name(models: LiveModels) -> None:
    with pytest.raises(InputError) as raised:
        LiveSession(models, LiveOptions(character="nobody"))
    assert raised.value.code == "unknown_character"


def test_what_a_stream_keeps_does_not_grow(models: LiveModels) -> None:
    """The line is said over and over, with words, frames and an interruption now and then."""
    session, before, after = LiveSession(models, FRAMES), list[dict[str, int]](), list[dict[str, int]]()
    for number in range(KEPT_TIMES):
        session.text("No, I have never seen those.")
        list(heard(session, chunk=4 * CHUNK))
        (after if number >= KEPT_TIMES // 2 else before).append(kept(session))
        if number % 3 == 2:
            session.interrupt()
    assert not grown(before, after)
    assert {"._agenda.by_id", "._shapes", "._own._voice._samples"} <= before[-1].keys()
