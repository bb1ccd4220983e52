"""The format of an author's edits: what is written can be read again, and every mistake is reported with its place."""

import json
from pathlib import Path

import pytest

from understudy.errors import InputError, UndecodableError
from understudy.model import Channel, Hand, Level, Mode
from understudy.model.edits import (
    BehaviorEdit,
    BehaviorReference,
    Edge,
    Edits,
    HeardTime,
    LineSettings,
    MarkPlace,
    Marks,
    Omission,
    WordEdit,
    WordMark,
    WordReference,
)
from understudy.schemas.affect import affect_track, read_affect
from understudy.schemas.edits import MOST_EDITS, edits_schema, read_edits, write_edits

ROOT = Path(__file__).parents[2]
NEVER = WordReference(3, "never")
EVERYTHING = Edits(
    line=LineSettings("reserved", Level.HIGH, 7, 0.2, Mode.PROSODY, read_affect("sad")),
    words=(
        WordEdit(NEVER, mark=WordMark.IMPORTANT),
        WordEdit(WordReference(4), mark=WordMark.STILL, start_s=1.0, end_s=1.2, heard=HeardTime(1.1, 1.25)),
    ),
    behaviors=(
        BehaviorEdit(
            of=BehaviorReference(Channel.GESTURE, NEVER, "negation", "negation", "NEGATION", -0.2),
            lexeme="STOP",
            hand=Hand.LEFT,
            amount=0.7,
            marks=Marks(start=MarkPlace(NEVER, -0.4), relax=MarkPlace(NEVER, 0.1, Edge.END)),
            lock=True,
        ),
        BehaviorEdit(of=BehaviorReference(Channel.EYES, NEVER, lexeme="BLINK"), omit=Omission.MUTED),
        BehaviorEdit(add=Channel.GAZE, on=NEVER, lexeme="LOOK", direction="UP"),
    ),
)


def test_what_is_written_reads_back() -> None:
    assert read_edits(write_edits(EVERYTHING)) == EVERYTHING


@pytest.mark.parametrize("told", ['"angry"', "[0.5, -0.2, 0.1]", "[[0, 0.5, -0.2, 0.1], [1.5, 0, 0.3, 0]]"])
def test_the_feeling_of_a_line_is_a_tone_numbers_or_a_track(told: str) -> None:
    edits = read_edits(f'{{"line": {{"affect": {told}}}}}'.encode())
    assert edits.line.affect == affect_track(json.loads(told))
    again = read_edits(write_edits(edits)).line.affect
    assert again is not None
    assert again.times_s == affect_track(json.loads(told)).times_s


@pytest.mark.parametrize("told", ['"grumpy"', "[0.5, 7, 0.1]", "[]"])
def test_what_is_no_feeling_is_refused_with_its_place(told: str) -> None:
    with pytest.raises(InputError, match=r"line\.affect") as caught:
        read_edits(f'{{"line": {{"affect": {told}}}}}'.encode())
    assert (caught.value.code, caught.value.field) == ("edits_wrong", "edits")


def test_nothing_is_no_edit() -> None:
    assert read_edits(b"{}") == Edits() == read_edits(write_edits(Edits()))


def _of_a_gesture(**told: object) -> str:
    """A file of edits of one gesture."""
    reference = {"channel": "gesture", "at": {"word": 0}, "lexeme": "BEAT"}
    return json.dumps({"behaviors": [{"of": reference, **told}]})


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ('{"version": 2}', ["version: input should be 1"]),
        ('{"behaviours": []}', ["behaviours: extra inputs are not permitted"]),
        ('{"line": {"seed": 1.5, "stillness": 2}}', ["line.seed: ", "line.stillness: "]),
        ('{"words": [{"at": {"word": 0}}]}', ["words[0]: it changes nothing"]),
        ('{"words": [{"at": {"word": 0}, "start_s": 1}]}', ["words[0]: give start_s and end_s together"]),
        ('{"words": [{"at": {"word": 0}, "start_s": 1, "end_s": 1}]}', ["words[0]: it starts at 1 s and ends at 1 s"]),
        ('{"behaviors": [{}]}', ["behaviors[0]: give either `of`, or both `add` and `on`"]),
        (_of_a_gesture(), ["behaviors[0]: it changes nothing"]),
        (_of_a_gesture(on={"word": 1}, lock=True), ["`on` goes with `add`, not with `of`"]),
        ('{"behaviors": [{"add": "head", "on": {"word": 0}}]}', ["what is added needs a lexeme"]),
        (_of_a_gesture(omit="muted", hand="left"), ["an edit with omit takes no other fields"]),
        (_of_a_gesture(direction="UP"), ["direction is for gaze, this is gesture"]),
        (
            '{"behaviors": [{"add": "posture", "on": {"word": 0}, "lexeme": "TURN", "hand": "left", "amount": 1}]}',
            ["hand is for gesture, this is posture", "a posture has no amount"],
        ),
        (
            '{"behaviors": [{"of": {"channel": "hands", "at": {"word": -1}}, "omit": "gone"}]}',
            ["behaviors[0].of.channel: ", "behaviors[0].of.at.word: ", "behaviors[0].omit: "],
        ),
        ('{"behaviors": [{"of": {"channel": "head", "at": {"word": 0}}, "lock": true}]}', ["say what it is"]),
        (_of_a_gesture(marks={"stroke": {"at": {"word": 0}, "offset_s": 61}}), ["offset_s: "]),
        ('{"words": [' + ",".join(["{}"] * (MOST_EDITS + 1)) + "]}", [f"words: {MOST_EDITS + 1} edits; 500 at most"]),
        ('{"words": [' + ",".join(["{}"] * 23) + "]}", ["; and 3 more"]),
    ],
)
def test_every_mistake_is_told_with_its_place(content: str, said: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        read_edits(content.encode())
    assert (caught.value.code, caught.value.field) == ("edits_wrong", "edits")
    for each in said:
        assert each in caught.value.message
    assert "\n" not in caught.value.message


def test_as_many_as_are_allowed_are_read() -> None:
    edits = [{"at": {"word": number}, "mark": "still"} for number in range(MOST_EDITS)]
    assert len(read_edits(json.dumps({"words": edits}).encode()).words) == MOST_EDITS


def test_what_is_no_object_is_told() -> None:
    with pytest.raises(UndecodableError):
        read_edits(b"[")
    with pytest.raises(InputError) as caught:
        read_edits(b"[]")
    assert (caught.value.code, caught.value.field) == ("not_an_object", "edits")


def test_the_documented_schema_is_that_of_the_edits() -> None:
    """Where it differs, write `edits_schema()` to the file."""
    assert (ROOT / "docs" / "edits.schema.json").read_text(encoding="utf-8") == edits_schema()
