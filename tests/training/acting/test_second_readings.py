"""Second readings of our own lines."""

import json

import pytest

from tests.support.shared_data import SHARED, needs
from training.acting.directed import CAREFUL, OWN, SECOND, is_held_out, read_lines
from training.acting.lines_check import strangers_in
from training.acting.second_readings import KINDS, careful_readings, pairs_of, second_readings, words_to_read

DIRECTING = SHARED / "directing"


@needs(DIRECTING)
def test_training_reads_no_line_a_second_time() -> None:
    second = {json.dumps(reading) for kind in KINDS for _, reading in pairs_of(kind)}
    lines = [line for line in read_lines(DIRECTING) if line.careful and "base" not in line.reading]
    assert second
    assert not second & {json.dumps(line.reading) for line in lines}
    assert len({line.name for line in lines}) == len(lines)


@pytest.mark.parametrize("kind", KINDS)
def test_both_readings_are_of_the_same_words(kind: str) -> None:
    pairs = pairs_of(kind)
    assert pairs
    assert all(first["text"] == second["text"] and first is not second for first, second in pairs)


def test_every_second_reading_is_of_a_kind_that_is_compared() -> None:
    for folder in (SECOND, SECOND / "deliveries"):
        assert {path.stem for path in folder.glob("*.jsonl")} == set(KINDS)


@needs(DIRECTING)
def test_every_second_reading_is_of_a_line_that_is_trained_on_and_within_its_words() -> None:
    lines = {line.name: line for line in read_lines(DIRECTING)}
    second = second_readings()
    assert len(second) > 803
    for name, reading in second.items():
        assert all(moment["last"] < len(lines[name].words) for moment in reading["moments"]), name


def test_lines_directed_with_care_when_they_were_written_have_their_own_reading_as_the_careful_one() -> None:
    careful = careful_readings()
    written = [json.loads(line) for path in OWN.rglob("*_8.jsonl") for line in path.read_text("utf-8").splitlines()]
    assert len(written) > 2600
    assert all(careful[each["id"]] == [each] for each in written)


def test_words_to_read_show_nothing_of_the_first_reading() -> None:
    text = "".join(path.read_text(encoding="utf-8") for path in OWN.glob("npc_[12].jsonl"))
    records = [json.loads(line) for line in text.splitlines()]
    expected = {
        " ".join([each["id"], *(f"{number}:{word}" for number, word in enumerate(each["text"].split()))])
        for each in records
    }
    assert set(words_to_read("npc", len(records))) == expected
    assert len(list(words_to_read("npc", 5))) == 5


def test_second_readings_of_unknown_lines_and_other_words_are_told() -> None:
    known = [{"id": "npc1-001", "text": "Halt."}]
    assert not list(strangers_in(known, known))
    again = [{"id": "npc1-002", "text": "Halt."}, {"id": "npc1-001", "text": "Stop."}]
    assert len(list(strangers_in(again, known))) == 2


@needs(DIRECTING)
def test_every_careful_reading_is_of_a_line_that_is_known_and_within_its_words() -> None:
    lines = {line.name: line for line in read_lines(DIRECTING)}
    careful = careful_readings()
    assert len(careful) > 2000
    for name, readings in careful.items():
        assert 1 <= len(readings) <= 3
        for reading in readings:
            assert all(0 <= each["first"] <= each["stroke"] <= each["last"] for each in reading["moments"]), name
            assert all(each["last"] < len(lines[name].words) for each in reading["moments"]), name


@needs(DIRECTING)
def test_three_directors_read_the_same_held_out_lines() -> None:
    """They are what `benchmarks.behavior.kinds --with-care` measures by, and nothing that is trained on."""
    paths = sorted(CAREFUL.glob("held_out_*.jsonl"))
    names = [{json.loads(line)["id"] for line in path.read_text(encoding="utf-8").splitlines()} for path in paths]
    assert len(names) == 3
    assert names[0] == names[1] == names[2] <= {line.name for line in read_lines(DIRECTING) if is_held_out(line)}
