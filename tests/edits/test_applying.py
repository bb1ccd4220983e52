"""Finding the behaviour an edit refers to after the choice has changed; a missing one is reported."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.edits import place_of, reference_to
from understudy.behavior.timing.conflicts import compete
from understudy.bml.writing.writer import write_bml
from understudy.edits.applying import edited, find_behaviors
from understudy.model import Analysis, Behavior, Channel, Hand, Level, Performance, Word
from understudy.model.edits import (
    MARKS,
    NO_EDITS,
    BehaviorEdit,
    BehaviorReference,
    Edits,
    Marks,
    Omission,
    WordEdit,
    WordMark,
    WordReference,
)
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform_analysis
from understudy.realization import BmlInput, PreparedSchedule, prepare_schedule, realize_prepared
from understudy.schemas.edits import read_edits, write_edits


def test_every_behaviour_is_found_by_what_an_author_writes_of_it(performance: Performance) -> None:
    kept = [each for each in performance.behaviors if each.kept]
    edits = [BehaviorEdit(of=reference_to(each, performance), lexeme="X") for each in kept]
    found = find_behaviors(performance, edits)
    assert found.notices == ()
    assert [found.behaviors[number].id for number in range(len(edits))] == [each.id for each in kept]


@pytest.mark.parametrize(
    "change",
    [{"lexeme": "ANOTHER"}, {"function": None}, {"function": "nothing", "family": None}, {"offset_s": None}],
)
def test_one_thing_in_common_is_enough(performance: Performance, change: dict[str, str | None]) -> None:
    gesture = next(each for each in performance.behaviors if each.kept and each.function and each.moment)
    reference = replace(reference_to(gesture, performance), **change)  # type: ignore[arg-type]
    assert find_behaviors(performance, [BehaviorEdit(of=reference, lexeme="X")]).behaviors == {0: gesture}


@pytest.mark.parametrize(
    ("reference", "code"),
    [
        (BehaviorReference(Channel.GESTURE, WordReference(0, "Yes"), lexeme="NEGATION"), "edit_word_gone"),
        (BehaviorReference(Channel.GESTURE, WordReference(0, "No,"), lexeme="GREETING"), "edit_behavior_gone"),
        (BehaviorReference(Channel.POSTURE, WordReference(0, "No,"), function="negation"), "edit_behavior_gone"),
    ],
)
def test_what_is_gone_is_told(performance: Performance, reference: BehaviorReference, code: str) -> None:
    found = find_behaviors(performance, [BehaviorEdit(of=reference, lexeme="X")])
    assert found.behaviors == {}
    assert [notice.code for notice in found.notices] == [code]
    assert found.notices[0].message.startswith("behaviors[0]: ")


def test_a_locked_one_that_is_gone_is_no_conflict(performance: Performance) -> None:
    reference = BehaviorReference(Channel.GESTURE, WordReference(0, "No,"), lexeme="GREETING")
    assert find_behaviors(performance, [BehaviorEdit(of=reference, lock=True)]).notices == ()


def test_two_edits_do_not_mean_the_same_behaviour(performance: Performance) -> None:
    gesture = next(each for each in performance.behaviors if each.kept and each.kind is Channel.GESTURE)
    edits = [BehaviorEdit(of=reference_to(gesture, performance), lexeme="X")] * 2
    found = find_behaviors(performance, edits)
    assert list(found.behaviors) == [0]
    assert [notice.code for notice in found.notices] == ["edit_behavior_gone"]


def _edited(understudy: Understudy, performance: Performance, *edits: BehaviorEdit) -> Performance:
    character = understudy.behavior.performers.named("default", Level.MEDIUM)
    return edited(performance, edits, character)


def _made(performance: Performance, number: int = 0) -> Behavior:
    [found] = [each for each in performance.behaviors if each.edit == number]
    return found


def _gestures(performance: Performance) -> list[Behavior]:
    return [each for each in performance.behaviors if each.kept and each.kind is Channel.GESTURE]


def _require_schedule(behaviors: Sequence[Behavior]) -> None:
    kept = [each for each in behaviors if each.kept]
    for behavior in kept:
        times_s = [at_s for _name, at_s in behavior.sync.in_order()]
        assert times_s == sorted(times_s), behavior
        assert times_s[0] >= 0, behavior
    for one, other in combinations(kept, 2):
        apart = one.sync.end <= other.sync.start or other.sync.end <= one.sync.start
        assert apart or not compete(one, other), (one, other)
    assert len({each.id for each in behaviors}) == len(behaviors)
    assert {each.lost_to for each in behaviors} - {None} <= {each.id for each in behaviors}


def test_a_line_without_edits_is_the_same(understudy: Understudy, analysis: Analysis, performance: Performance) -> None:
    assert perform_analysis(understudy, analysis, Options().with_edits(NO_EDITS)) == performance


def test_a_gesture_is_moved_with_all_its_marks(understudy: Understudy, performance: Performance) -> None:
    gesture = _gestures(performance)[0]
    assert gesture.sync.stroke is not None
    place = place_of(gesture.sync.stroke + 0.2, gesture, performance)
    edit = BehaviorEdit(of=reference_to(gesture, performance), marks=Marks(stroke=place))
    found = _made(_edited(understudy, performance, edit))
    assert dict(found.sync.in_order()) == pytest.approx({name: at + 0.2 for name, at in gesture.sync.in_order()})
    assert (found.lexeme, found.function, found.rule) == (gesture.lexeme, gesture.function, gesture.rule)


def test_marks_go_with_their_words(understudy: Understudy, analysis: Analysis, performance: Performance) -> None:
    """In a recording that is spoken half as fast the stroke is as long after its word as the author wanted; the
    first gesture is made in both."""
    gesture = _gestures(performance)[0]
    place = place_of((gesture.sync.stroke or 0) + 0.1, gesture, performance)
    edits = Edits(behaviors=(BehaviorEdit(of=reference_to(gesture, performance), marks=Marks(stroke=place)),))
    slow = tuple(_slower(word) for word in analysis.utterance.words)
    utterance = replace(analysis.utterance, words=slow, duration_s=2 * (analysis.utterance.duration_s or 0))
    again = perform_analysis(understudy, replace(analysis, utterance=utterance), Options().with_edits(edits))
    word = slow[gesture.first].interval
    assert word is not None
    assert _made(again).sync.stroke == pytest.approx(word.start_s + place.offset_s, abs=0.001)


def _slower(word: Word) -> Word:
    assert word.interval is not None
    return replace(
        word, interval=replace(word.interval, start_s=2 * word.interval.start_s, end_s=2 * word.interval.end_s)
    )


def test_lexeme_hand_and_size_are_the_authors(understudy: Understudy, performance: Performance) -> None:
    gesture = _gestures(performance)[0]
    reference = reference_to(gesture, performance)
    edit = BehaviorEdit(of=reference, lexeme="POINT_FRONT", hand=Hand.LEFT, amount=0.9)
    found = _made(_edited(understudy, performance, edit))
    assert (found.lexeme, found.hand, found.amount) == ("POINT_FRONT", Hand.LEFT, 0.9)
    assert found.sync.stroke == pytest.approx(gesture.sync.stroke, abs=0.001)


@pytest.mark.parametrize("omission", Omission)
def test_what_is_omitted_is_not_made_and_says_so(
    understudy: Understudy, performance: Performance, omission: Omission
) -> None:
    gesture = _gestures(performance)[0]
    found = _edited(understudy, performance, BehaviorEdit(of=reference_to(gesture, performance), omit=omission))
    assert (_made(found).kept, _made(found).reason) == (False, f"{omission} by the author")
    assert len(_gestures(found)) == len(_gestures(performance)) - 1


def test_a_gesture_is_added_on_a_word(understudy: Understudy, performance: Performance) -> None:
    edit = BehaviorEdit(add=Channel.GESTURE, on=WordReference(17, "What"), lexeme="QUESTION", hand=Hand.BOTH)
    found = _made(_edited(understudy, performance, edit))
    assert (found.first, found.lexeme, found.hand, found.kept) == (17, "QUESTION", Hand.BOTH, True)


@pytest.mark.parametrize(
    ("edit", "code"),
    [
        (BehaviorEdit(add=Channel.GESTURE, on=WordReference(17, "What"), lexeme="QUESTIN"), "edit_lexeme_unknown"),
        (BehaviorEdit(add=Channel.GESTURE, on=WordReference(17, "Who"), lexeme="QUESTION"), "edit_word_gone"),
    ],
)
def test_what_cannot_be_added_is_told(
    understudy: Understudy, performance: Performance, edit: BehaviorEdit, code: str
) -> None:
    found = _edited(understudy, performance, edit)
    assert found.behaviors == performance.behaviors
    assert [notice.code for notice in found.notices[len(performance.notices) :]] == [code]


def test_a_mark_that_cannot_be_there_is_told(understudy: Understudy, performance: Performance) -> None:
    gesture = _gestures(performance)[0]
    place = place_of((gesture.sync.stroke or 0) + 0.3, gesture, performance)
    edit = BehaviorEdit(of=reference_to(gesture, performance), marks=Marks(start=place))
    found = _edited(understudy, performance, edit)
    assert found.notices[-1].code == "edit_mark_moved"
    assert "behaviors[0].marks.start" in found.notices[-1].message


def test_of_two_edits_in_each_others_way_the_second_is_told(understudy: Understudy, performance: Performance) -> None:
    on = WordReference(17, "What")
    edits = [BehaviorEdit(add=Channel.GESTURE, on=on, lexeme=lexeme) for lexeme in ("QUESTION", "BEAT")]
    found = _edited(understudy, performance, *edits)
    assert (_made(found, 0).kept, _made(found, 1).kept) == (True, False)
    assert [notice.code for notice in found.notices[len(performance.notices) :]] == ["edit_unplayed"]


@pytest.mark.parametrize("seed", range(1, 5))
def test_a_locked_gesture_survives_another_choice(
    understudy: Understudy, analysis: Analysis, performance: Performance, seed: int
) -> None:
    reserved = understudy.behavior.performers.named("reserved", Level.MEDIUM)
    known = {each.lexeme for each in reserved.entries.values()}
    gesture = next(each for each in _gestures(performance) if each.lexeme in known)
    marks = {name: place_of(at_s, gesture, performance) for name, at_s in gesture.sync.in_order()}
    lock = BehaviorEdit(
        of=reference_to(gesture, performance),
        lexeme=gesture.lexeme,
        hand=gesture.hand,
        amount=gesture.amount,
        marks=Marks(**marks),
        lock=True,
    )
    options = Options(seed=seed, character="reserved").with_edits(Edits(behaviors=(lock,)))
    found = _made(perform_analysis(understudy, analysis, options))
    assert (found.kept, found.lexeme, found.hand) == (True, gesture.lexeme, gesture.hand)
    assert found.sync.stroke == pytest.approx(gesture.sync.stroke, abs=0.002)


def test_a_word_marked_still_keeps_the_hands_at_rest_and_one_marked_important_gets_a_gesture(
    understudy: Understudy, analysis: Analysis, performance: Performance
) -> None:
    struck = {moment.stroke for moment in performance.moments if moment.channel is Channel.GESTURE}
    still = min(struck)
    important = next(
        word.index for word in analysis.utterance.words if not struck & set(range(word.index - 2, word.index + 3))
    )
    marks = [(still, WordMark.STILL), (important, WordMark.IMPORTANT)]
    edits = Edits(words=tuple(WordEdit(WordReference(word), mark=mark) for word, mark in marks))
    found = perform_analysis(understudy, analysis, Options().with_edits(edits))
    now = {moment.stroke for moment in found.moments if moment.channel is Channel.GESTURE}
    assert important in now
    assert still not in now


def test_a_still_line_keeps_what_the_author_changed_longest(
    understudy: Understudy, analysis: Analysis, performance: Performance
) -> None:
    brows = min(
        (each for each in performance.behaviors if each.kept and each.kind is Channel.FACE),
        key=lambda each: each.priority,
    )
    edit = BehaviorEdit(of=reference_to(brows, performance), amount=0.8)
    options = Options(stillness=0.8)
    assert brows.lexeme not in {
        each.lexeme
        for each in perform_analysis(understudy, analysis, options).behaviors
        if each.kept and each.first == brows.first
    }
    found = _made(perform_analysis(understudy, analysis, options.with_edits(Edits(behaviors=(edit,)))))
    assert (found.kept, found.amount) == (True, 0.16)


def test_motion_of_the_edited_bml_is_that_of_the_performance(
    understudy: Understudy, analysis: Analysis, performance: Performance
) -> None:
    """Another of each channel, everything moved a little, half of it larger or smaller."""
    kept = [each for each in performance.behaviors if each.kept]
    edits = tuple(
        BehaviorEdit(
            of=reference_to(each, performance),
            marks=Marks(ready=place_of((each.sync.ready or 0) + 0.11, each, performance)),
            amount=0.37 if number % 2 and each.kind is not Channel.POSTURE and each.amount is not None else None,
        )
        for number, each in enumerate(kept)
    )
    found = perform_analysis(understudy, analysis, Options().with_edits(Edits(behaviors=edits)))
    _require_schedule(found.behaviors)
    direct = realize_prepared(understudy.realizer, PreparedSchedule.of(found))
    read = prepare_schedule(None, BmlInput(write_bml(found), Path("line.bml")))
    again = realize_prepared(understudy.realizer, read)
    assert again.motion.body.rotations.tobytes() == direct.motion.body.rotations.tobytes()
    assert again.motion.shapes.tobytes() == direct.motion.shapes.tobytes()


_CHANGED = st.lists(
    st.tuples(
        st.integers(0, 200),
        st.dictionaries(st.sampled_from(MARKS), st.floats(-2, 2), max_size=3),
        st.sampled_from(("BEAT", "QUESTION", "POINT_FRONT", None)),
        st.sampled_from((*Hand, None)),
        st.sampled_from((*Omission, None)),
        st.booleans(),
    ),
    max_size=6,
    unique_by=lambda each: each[0],
)
_ADDED = st.lists(
    st.tuples(
        st.integers(0, 21),
        st.sampled_from(((Channel.GESTURE, "GIVE"), (Channel.HEAD, "NOD"), (Channel.FACE, "RAISE_BROWS"))),
    ),
    max_size=2,
)


@given(_CHANGED, _ADDED)
def test_whatever_is_changed_a_schedule_stays_one(
    understudy: Understudy,
    performance: Performance,
    changed: list[tuple[int, dict[str, float], str | None, Hand | None, Omission | None, bool]],
    added: list[tuple[int, tuple[Channel, str]]],
) -> None:
    kept = [each for each in performance.behaviors if each.kept]
    edits = [BehaviorEdit(add=channel, on=WordReference(word), lexeme=lexeme) for word, (channel, lexeme) in added]
    for number, offsets_s, lexeme, hand, omission, lock in changed:
        behavior = kept[number % len(kept)]
        is_gesture = behavior.kind is Channel.GESTURE
        places = {
            name: place_of(behavior.sync.start + offset_s, behavior, performance)
            for name, offset_s in offsets_s.items()
        }
        edit = BehaviorEdit(
            of=reference_to(behavior, performance),
            lexeme=lexeme if is_gesture and not omission else None,
            hand=hand if is_gesture and not omission else None,
            marks=Marks(**places),
            omit=omission,
            lock=lock and not omission,
        )
        edits += [edit] if edit != BehaviorEdit(of=edit.of) else []
    found = _edited(understudy, performance, *edits)
    _require_schedule(found.behaviors)
    assert found == _edited(understudy, performance, *read_edits(write_edits(Edits(behaviors=tuple(edits)))).behaviors)
