"""A director's notes: checked against words and vocabulary, conflicts reported, and applied to a plan."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from understudy.behavior.candidates.notes import check_direction, conflicts, directed, is_avoided
from understudy.behavior.candidates.vocabulary import FACES, GESTURES, HEADS
from understudy.errors import InputError
from understudy.model import Avoidance, Channel, DirectedMoment, Direction, Moment

WORDS = 12


def _planned(first: int, last: int, *families: str, channel: Channel = Channel.GESTURE, stroke: int = -1) -> Moment:
    name = f"{channel}{first}"
    shares = tuple(1 / (place + 2) for place in range(len(families)))
    return Moment(name, channel, first, last, last if stroke < 0 else stroke, families, 7.5, shares)


@pytest.mark.parametrize(
    ("direction", "code", "said"),
    [
        (Direction((DirectedMoment(0, 12, 3),)), "direction_span", "moments[0].last: there is no word 12"),
        (Direction((DirectedMoment(-1, 2, 2),)), "direction_span", "moments[0].first"),
        (Direction((DirectedMoment(0, 3, 4),)), "direction_span", "first 0, stroke 4, last 3"),
        (Direction((DirectedMoment(3, 2, 3),)), "direction_span", "moments[0]: "),
        (Direction(avoid=(Avoidance(5, 4, ("self",)),)), "direction_span", "avoid[0]: first 5, last 4"),
        (Direction((DirectedMoment(0, 1, 1, importance=4),)), "direction_importance", "moments[0].importance: 4"),
        (Direction((DirectedMoment(0, 1, 1, gesture=("adressee",)),)), "direction_family", "mean 'addressee'?"),
        (
            Direction((DirectedMoment(0, 1, 1, head=("smile",)),)),
            "direction_family",
            "moments[0].head: unknown 'smile'",
        ),
        (Direction(avoid=(Avoidance(0, 1, ("smile", "hand")),)), "direction_family", "avoid[0].what: unknown 'hand'"),
    ],
)
def test_a_mistake_is_told_with_its_note_and_key(direction: Direction, code: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        check_direction(direction, words=WORDS)
    assert (caught.value.code, caught.value.field) == (code, "direction")
    assert said in caught.value.message


def test_notes_that_fit_the_words_pass() -> None:
    moment = DirectedMoment(0, 11, 0, gesture=tuple(GESTURES), head=tuple(HEADS), face=tuple(FACES), gaze=("target",))
    check_direction(Direction((moment,), (Avoidance(11, 11, ("hands", "nod", "squint")),)), words=WORDS)


@pytest.mark.parametrize(
    ("word", "families", "expected"),
    [
        (4, ("self",), True),
        (3, ("self",), True),
        (7, ("self",), True),
        (2, ("self",), False),
        (8, ("self",), False),
        (5, ("self", "heart"), True),
        (5, ("self", "present"), False),
        (5, (), False),
    ],
)
def test_what_is_wrong_is_wrong_beside_its_words_too(word: int, families: tuple[str, ...], expected: bool) -> None:
    direction = Direction(avoid=(Avoidance(4, 6, ("self", "heart")),))
    assert is_avoided(direction, word, families) is expected


def test_hands_are_gestures_and_any_is_everything() -> None:
    hands, anything = (Direction(avoid=(Avoidance(0, 0, (what,)),)) for what in ("hands", "any"))
    assert is_avoided(hands, 0, ("beat",))
    assert not is_avoided(hands, 0, ("nod",), channel=Channel.HEAD)
    assert is_avoided(anything, 0, ("nod",), channel=Channel.HEAD)


def test_a_note_stands_in_place_of_what_it_overlaps_on_its_channels() -> None:
    note = DirectedMoment(2, 5, 4, importance=3, gesture=("dismiss", "away"), face=("frown",))
    before, beside = _planned(0, 2, "present"), _planned(6, 8, "self", "heart")
    nod = _planned(3, 4, "nod", channel=Channel.HEAD)
    result = {moment.id: moment for moment in directed(Direction((note,)), [before, beside, nod])}
    assert set(result) == {"note0.gesture", "note0.face", beside.id, nod.id}
    own = result["note0.gesture"]
    assert (own.first, own.stroke, own.last, own.families, own.note) == (2, 4, 5, ("dismiss", "away"), 0)
    assert own.importance > before.importance
    assert [lost.families for lost in own.rejected] == [("present",)]
    assert (result[beside.id], result[nod.id]) == (beside, nod)


def test_more_important_notes_outrank_others() -> None:
    notes = (DirectedMoment(0, 1, 1, importance=1, gesture=("beat",)), DirectedMoment(4, 5, 5, 3, gesture=("fist",)))
    small, great = directed(Direction(notes), [_planned(8, 9, "present")])[:2]
    assert small.importance < great.importance


def test_stillness_leaves_nothing_of_its_channel() -> None:
    still = DirectedMoment(0, 11, 0, gesture=("still",), face=("neutral",))
    plan = [
        _planned(1, 3, "self"),
        _planned(1, 3, "smile", channel=Channel.FACE),
        _planned(0, 9, "nod", channel=Channel.HEAD),
    ]
    assert [moment.channel for moment in directed(Direction((still,)), plan)] == [Channel.HEAD]


def test_a_gesture_or_else_stillness_is_the_gesture() -> None:
    [moment] = directed(Direction((DirectedMoment(0, 1, 1, gesture=("point_there", "still")),)), [])
    assert moment.families == ("point_there",)


def test_complete_notes_leave_the_hands_nothing_else() -> None:
    notes = Direction((DirectedMoment(0, 1, 1, gesture=("quote",)),), complete=True)
    plan = [_planned(8, 9, "present"), _planned(8, 9, "nod", channel=Channel.HEAD)]
    assert [moment.families for moment in directed(notes, plan)] == [("quote",), ("nod",)]


def test_what_is_to_be_avoided_leaves_the_plan_family_by_family() -> None:
    direction = Direction(avoid=(Avoidance(3, 3, ("self", "smile")),))
    both, lost = _planned(2, 4, "self", "heart", "present"), _planned(1, 3, "self")
    elsewhere = _planned(3, 9, "self")
    smile = _planned(0, 9, "smile", channel=Channel.FACE)
    [left, same] = directed(direction, [both, lost, elsewhere, smile])
    assert (left.families, left.shares) == (("heart", "present"), both.shares[1:])
    assert same == elsewhere


def test_a_note_goes_without_the_families_that_are_to_be_avoided() -> None:
    direction = Direction((DirectedMoment(0, 2, 1, gesture=("self", "heart")),), (Avoidance(0, 2, ("self",)),))
    assert [moment.families for moment in directed(direction, [])] == [("heart",)]
    assert conflicts(direction) == ()


def test_of_two_strokes_on_a_word_the_more_important_is_made_and_it_is_told() -> None:
    notes = (
        DirectedMoment(0, 3, 3, importance=1, gesture=("self",), head=("nod",)),
        DirectedMoment(2, 4, 3, importance=2, gesture=("beat",)),
    )
    [notice] = conflicts(Direction(notes))
    assert notice.code == "direction_strokes"
    assert "moments[0] and moments[1]" in notice.message
    assert "the gesture of moments[1] is made" in notice.message
    assert [moment.families for moment in directed(Direction(notes), [])] == [("nod",), ("beat",)]


def test_a_gesture_amid_stillness_and_what_is_avoided_are_made_and_told() -> None:
    still = DirectedMoment(0, 9, 0, gesture=("still",))
    amid = DirectedMoment(4, 5, 5, gesture=("fist",), face=("smile",))
    direction = Direction((still, amid), (Avoidance(5, 6, ("smile", "fist")), Avoidance(6, 7, ("hands",))))
    assert [notice.code for notice in conflicts(direction)] == [
        "direction_still",
        "direction_avoided",
        "direction_avoided",
    ]
    assert {moment.families for moment in directed(direction, [])} == {("fist",), ("smile",)}


_SPANS = st.tuples(*[st.integers(0, WORDS - 1)] * 3).map(sorted)
_NOTES = st.builds(
    lambda span, importance, gesture, head: DirectedMoment(span[0], span[2], span[1], importance, gesture, head),
    _SPANS,
    st.integers(1, 3),
    st.lists(st.sampled_from(sorted(GESTURES)), max_size=3).map(tuple),
    st.lists(st.sampled_from(sorted(HEADS)), max_size=2).map(tuple),
)
_PLANS = st.builds(
    lambda span, family: _planned(span[0], span[2], family, stroke=span[1]), _SPANS, st.sampled_from(sorted(GESTURES))
)


@given(st.lists(_NOTES, max_size=5), st.lists(_PLANS, max_size=6), st.booleans())
def test_no_plan_is_left_where_a_note_speaks(notes: list[DirectedMoment], plan: list[Moment], complete: bool) -> None:
    direction = Direction(tuple(notes), complete=complete)
    check_direction(direction, words=WORDS)
    result = directed(direction, plan)
    told = {
        loser for loser in range(len(notes)) for notice in conflicts(direction) if f"moments[{loser}]" in notice.message
    }
    for number, note in enumerate(notes):
        wants = [kind for kind in note.gesture[:1] if kind != "still"]
        made = [moment for moment in result if moment.note == number and moment.channel is Channel.GESTURE]
        assert len(made) == len(wants) or number in told
        if note.gesture and number not in told:
            planned = [moment for moment in result if moment.note is None and moment.channel is Channel.GESTURE]
            assert not any(moment.first <= note.last and note.first <= moment.last for moment in planned)
    assert not complete or all(moment.note is not None for moment in result if moment.channel is Channel.GESTURE)
    assert [moment for moment in result if moment.note is None] == sorted(
        (moment for moment in plan if moment in result), key=lambda moment: (moment.first, moment.stroke, moment.id)
    )
