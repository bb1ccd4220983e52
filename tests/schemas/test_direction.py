"""A director's notes as JSON: read if valid, mistakes reported by note and key; the schema is the documented one."""

import json
from pathlib import Path

import pytest

from tests.support.shared_data import SHARED, needs
from understudy.behavior.candidates.notes import check_direction
from understudy.errors import InputError, UndecodableError
from understudy.model import Avoidance, DirectedMoment, Direction
from understudy.schemas.direction import MOST_NOTES, direction_fields, direction_schema, read_direction

ROOT = Path(__file__).resolve().parents[2]
DIRECTING = SHARED / "directing"


def test_notes_are_read() -> None:
    content = json.dumps(
        {
            "id": "scene 4, line 12",
            "moments": [
                {
                    "first": 1,
                    "last": 3,
                    "stroke": 2,
                    "importance": 3,
                    "idea": "all",
                    "gesture": ["all_sweep", "present"],
                },
                {"first": 5, "last": 6, "head": ["nod"], "face": ["smile"], "gaze": ["down"]},
            ],
            "avoid": [{"first": 0, "last": 0, "what": ["self", "no_negation"], "why": "not me"}],
            "complete": True,
        }
    )
    assert read_direction(content.encode()) == Direction(
        moments=(
            DirectedMoment(1, 3, 2, 3, gesture=("all_sweep", "present"), idea="all"),
            DirectedMoment(5, 6, 6, head=("nod",), face=("smile",), gaze=("down",)),
        ),
        avoid=(Avoidance(0, 0, ("self", "negation"), "not me"),),
        complete=True,
    )
    assert read_direction(b"{}") == Direction()


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ('{"moments": [{"first": 0}]}', "moments[0].last: field required"),
        (
            '{"moments": [{"first": 0, "last": 1}, {"first": 0, "last": 1, "strok": 1}]}',
            "moments[1].strok: extra inputs",
        ),
        ('{"moments": [{"first": 0, "last": "1"}]}', "moments[0].last: input should be a valid integer"),
        ('{"moments": [{"first": -1, "last": 1}]}', "moments[0].first"),
        ('{"moments": [{"first": 0, "last": 1, "importance": 5}]}', "moments[0].importance"),
        ('{"moments": [{"first": 0, "last": 1, "gesture": "self"}]}', "moments[0].gesture"),
        ('{"moments": [{"first": 0, "last": 1, "gesture": [3]}]}', "moments[0].gesture[0]"),
        ('{"moments": {}}', "moments: "),
        ('{"avoid": [{"first": 0, "last": 1, "what": []}]}', "avoid[0].what"),
        ('{"complete": 1}', "complete: "),
        ('{"moments": [' + ",".join(['{"first": 0, "last": 0}'] * (MOST_NOTES + 1)) + "]}", "moments: "),
        ('{"moments": [' + ",".join(["{}"] * 4) + "]}", "; and 3 more"),
    ],
)
def test_what_is_wrong_is_told_by_note_and_key(content: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        read_direction(content.encode())
    assert (caught.value.code, caught.value.field) == ("direction_wrong", "direction")
    assert said in caught.value.message
    assert "\n" not in caught.value.message


def test_notes_that_are_sent_are_read_as_they_were() -> None:
    """As a batch sends them to a service."""
    notes = {
        "moments": [{"first": 0, "last": 1, "gesture": ["negation"], "idea": "no"}],
        "avoid": [{"first": 2, "last": 2, "what": ["hands"]}],
        "always": [{"first": 0, "last": 0, "what": "nod"}],
        "never": [{"first": 1, "last": 2, "what": "any"}, {"first": 3, "last": 3, "what": "hands"}],
        "complete": True,
    }
    direction = read_direction(json.dumps(notes).encode())
    assert read_direction(json.dumps(direction_fields(direction)).encode()) == direction


def test_what_is_no_object_is_told() -> None:
    with pytest.raises(UndecodableError):
        read_direction(b"[")
    with pytest.raises(InputError) as caught:
        read_direction(b"[]")
    assert (caught.value.code, caught.value.field) == ("not_an_object", "direction")


def test_the_documented_schema_is_that_of_the_notes() -> None:
    """Where it differs, write `direction_schema()` to the file."""
    assert (ROOT / "docs" / "direction.schema.json").read_text(encoding="utf-8") == direction_schema()


@needs(DIRECTING)
def test_every_reading_of_the_directed_lines_is_a_direction() -> None:
    names = ("dev-lines.jsonl", "directed-lines.jsonl")
    lines = [line for name in names for line in (DIRECTING / name).read_text(encoding="utf-8").splitlines()]
    lengths = {line["id"]: len(line["words"]) for line in map(json.loads, lines)}
    readings = [path for path in DIRECTING.glob("*.jsonl") if not path.name.endswith("lines.jsonl")]
    read = [line for path in readings for line in path.read_text(encoding="utf-8").splitlines() if line]
    for line in read:
        check_direction(read_direction(line.encode()), words=lengths[json.loads(line)["id"]])
    assert len(read) > 5000
