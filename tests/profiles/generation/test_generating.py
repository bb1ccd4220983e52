"""The gesture script: the steps of NGS §3.3, and what must hold of every script."""

from collections import Counter
from dataclasses import replace
from itertools import pairwise

import pytest

from tests.support.words.scripted import habit, line, profile, repertoire
from understudy.model import Interval
from understudy.profiles.annotation.model import TaggedWords
from understudy.profiles.generation.candidates import ClosedWords
from understudy.profiles.generation.generating import Speaker, generate
from understudy.profiles.generation.script import GestureScript, behaviors_of

TEXT = "one two three four five six seven eight nine ten"
EVERY_WORD = [TaggedWords("x", word, word) for word in range(10)]


def _script(per_minute: float = 60.0, *, seed: int = 0, **made: float) -> GestureScript:
    speaker = profile({"A": habit(1.0, **made)}, {"any": {"A": 0.5}}, per_minute=per_minute)
    return generate(Speaker(speaker, repertoire("A"), seed), line(TEXT), EVERY_WORD)


def test_strokes_end_with_their_words_by_the_offset_and_the_lead() -> None:
    """Steps 12 and 13: word end + the speaker's offset − .3 s."""
    words = line(TEXT).words
    script = _script(40, offset_s=0.1)
    assert script.made
    for gesture in script.made:
        interval = words[gesture.word].interval
        assert interval is not None
        moved_s = float(gesture.reason.split()[0]) if gesture.reason else 0.0
        assert gesture.strokes[0].end_s == pytest.approx(interval.end_s + 0.1 - 0.3 + moved_s, abs=0.01)
        assert gesture.strokes[0].duration_s == pytest.approx(0.3)


def test_after_strokes_end_with_following_words_and_lead_less() -> None:
    words = line(TEXT).words
    ends = {round(word.interval.end_s - 0.12, 6) for word in words if word.interval}
    made = [gesture for seed in range(5) for gesture in _script(15, seed=seed, strokes=3.0).made]
    assert any(len(gesture.strokes) == 3 for gesture in made)
    for gesture in made:
        for one, other in pairwise(gesture.strokes):
            assert other.end_s - one.end_s >= 0.35
            assert round(other.end_s, 6) in ends


def test_phases_are_in_order_and_units_end_in_one_rest() -> None:
    for seed in range(10):
        script = _script(60, seed=seed)
        for gesture in script.made:
            assert 0 <= gesture.start_s <= gesture.strokes[0].start_s
            assert gesture.strokes[-1].end_s <= gesture.relax_s <= gesture.end_s
        for one, other in pairwise(script.made):
            assert one.end_s <= other.start_s + 1e-9
        assert [name for unit in script.units for name in unit.gestures] == [each.id for each in script.made]
        for unit in script.units:
            own = [each for each in script.made if each.id in unit.gestures]
            assert all(one.end_s == pytest.approx(other.start_s) for one, other in pairwise(own))
            assert own[-1].end_s > own[-1].relax_s


def test_near_gestures_of_a_segment_are_one_unit_and_far_ones_are_not() -> None:
    speaker = profile({"A": habit(1.0)}, {"any": {"A": 0.5}}, per_minute=30)
    tags = [TaggedWords("x", 1, 1), TaggedWords("x", 4, 4)]
    together = generate(Speaker(speaker, repertoire("A")), line(TEXT), tags)
    for seed in range(20):
        together = generate(Speaker(speaker, repertoire("A"), seed), line(TEXT), tags)
        if len(together.made) == 2:
            break
    assert [len(unit.gestures) for unit in together.units] == [2]  # 1.2 s less a stroke of .3 s apart
    apart = generate(Speaker(speaker, repertoire("A"), seed), line(TEXT, pauses={3: 0.7}), tags)
    if len(apart.made) == 2:
        assert [len(unit.gestures) for unit in apart.units] == [1, 1]


def test_the_same_seed_says_the_same_and_another_something_else() -> None:
    assert _script(seed=3) == _script(seed=3)
    assert len({_script(20, seed=seed).made for seed in range(10)}) > 1


def test_closed_words_and_taken_hands_are_left_alone() -> None:
    speaker = profile({"A": habit(1.0)}, {"any": {"A": 0.5}}, per_minute=60)
    closed = replace(repertoire("A"), closed=(ClosedWords(0, 6),))
    assert all(each.word > 6 for each in generate(Speaker(speaker, closed), line(TEXT), EVERY_WORD).made)
    taken = replace(repertoire("A"), taken=(Interval(0.0, 3.0),))
    script = generate(Speaker(speaker, taken), line(TEXT), EVERY_WORD)
    assert all(each.strokes[0].start_s > 3.0 for each in script.made)
    assert any("already make another" in (each.reason or "") for each in script.gestures if not each.kept)


def test_an_independent_hold_begins_with_its_word() -> None:
    script = _script(20, held=1.0)
    words = line(TEXT).words
    for gesture in script.made:
        assert gesture.held
        interval = words[gesture.word].interval
        assert interval is not None
        if not gesture.reason:
            assert gesture.strokes[0].start_s == pytest.approx(interval.start_s - 0.3)


def test_words_without_times_have_no_gestures() -> None:
    untimed = replace(line(TEXT), words=tuple(replace(word, interval=None) for word in line(TEXT).words))
    speaker = profile({"A": habit(1.0)}, {"any": {"A": 0.5}})
    assert generate(Speaker(speaker, repertoire("A")), untimed, EVERY_WORD).gestures == ()


def test_behaviors_of_a_script_have_its_strokes_and_rests() -> None:
    script = _script(40, strokes=2.0)
    behaviors = behaviors_of(script, {("x", 4, 4): "f4"})
    gestures = [each for each in behaviors if each.kind == "gesture" and each.kept]
    assert [each.id for each in gestures] == [each.id for each in script.made]
    for behavior, gesture in zip(gestures, script.made, strict=True):
        assert behavior.after_strokes_s is not None
        assert len(behavior.after_strokes_s) == len(gesture.strokes) - 1
        times = [time_s for _name, time_s in behavior.sync.in_order()]
        assert times == sorted(times)
        assert behavior.function == ("f4" if gesture.first == 4 else None)
    postures = [each.lexeme for each in behaviors if each.kind == "posture"]
    assert postures[0] in {"HANDS_CLASPED", "HANDS_AT_SIDE", "HANDS_IN_POCKETS"}


def test_two_gestures_share_what_lacks_between_them() -> None:
    """One that ends .2 s after its word before one that ends .2 s before: each is moved by half."""
    lexemes = {"A": habit(0.5, offset_s=0.2), "B": habit(0.5, offset_s=-0.2)}
    speaker = profile(lexemes, {"x": {"A": 0.9}, "y": {"B": 0.9}, "any": {}}, per_minute=26)
    tags = [TaggedWords("x", 4, 4), TaggedWords("y", 6, 6)]
    one, other = generate(Speaker(speaker, repertoire("A", "B")), line(TEXT), tags).made
    ends_s = [word.interval.end_s for word in line(TEXT).words if word.interval]
    early_s = ends_s[4] + 0.2 - 0.3 - one.strokes[0].end_s
    assert early_s > 0.02
    assert one.reason is not None
    assert one.reason.endswith("earlier: too little time after it")
    assert other.strokes[0].end_s - (ends_s[6] - 0.2 - 0.3) == pytest.approx(early_s)


def test_the_one_before_is_not_moved_into_what_is_asked_of_the_hands() -> None:
    lexemes = {"A": habit(0.5, offset_s=0.2), "B": habit(0.5, offset_s=-0.2)}
    speaker = profile(lexemes, {"x": {"A": 0.9}, "y": {"B": 0.9}, "any": {}}, per_minute=26)
    tags = [TaggedWords("x", 4, 4), TaggedWords("y", 6, 6)]
    asked = replace(
        repertoire("A", "B"), taken=(Interval(0.0, 1.59),)
    )  # A's stroke begins at 2.1, .5 s after it is free
    one, other = generate(Speaker(speaker, asked), line(TEXT), tags).made
    assert one.reason is None
    assert other.reason is not None
    assert "later" in other.reason


WORDS, SEGMENTS = 20, 12


def test_every_segment_has_what_its_time_allots() -> None:
    """A word takes .4 s, a segment 8 s, its pause 1 s: at 20 gestures a minute that is 3, and 2.67 for the
    first, without a pause. One gesture at most is made up for others."""
    words = WORDS * SEGMENTS
    speaker = profile({"A": habit(1.0)}, {"any": {"A": 0.5}}, per_minute=20)
    text = line(" ".join("x" for _each in range(words)), pauses=dict.fromkeys(range(WORDS, words, WORDS), 1.0))
    tags = [TaggedWords("x", word, word) for word in range(words)]
    for seed in range(5):
        made = generate(Speaker(speaker, repertoire("A"), seed), text, tags).made
        in_segment = Counter(each.word // WORDS for each in made)
        assert all(1 <= in_segment[segment] <= 4 for segment in range(SEGMENTS))
        assert abs(len(made) - 20 * (8 * SEGMENTS + SEGMENTS - 1) / 60) < 2
