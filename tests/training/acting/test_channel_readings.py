"""What readings of head or face alone ask for, and whether those that are here are sound."""

from collections import defaultdict

import numpy as np
import pytest

from tests.support.shared_data import SHARED, needs
from training.acting.channel_readings import KINDS, as_moments, asked_by, channel_readings, problems_of
from training.acting.directed import FACE, DirectedLine, is_held_out, read_alike, read_lines, targets_of
from training.acting.second_readings import readings_by_three

DIRECTING = SHARED / "directing"

SMILES = {"id": "a", "idea": "pleased", "spans": [{"first": 1, "last": 2, "kinds": ["smile", "brows_up"]}]}
BLANK = {"id": "a", "idea": "just tells", "spans": []}


def test_a_face_is_asked_for_on_all_words_of_its_phrase() -> None:
    faces = asked_by([SMILES], "face", 4)
    assert faces[:, FACE.index("smile")].tolist() == [0, 1, 1, 0]
    assert faces.sum() == 4


def test_several_readings_ask_by_their_share() -> None:
    assert asked_by([SMILES, BLANK], "face", 4)[1, FACE.index("brows_up")] == 0.5
    assert not asked_by([BLANK], "face", 4).any()


def test_as_moments_they_ask_for_the_same() -> None:
    line = DirectedLine("a", ("a", "b", "c", "d"), as_moments(SMILES, "face"))
    assert np.array_equal(targets_of(line).face, asked_by([SMILES], "face", 4))
    assert not targets_of(line).stroke.any()


def test_a_word_too_many_and_an_unknown_kind_are_told() -> None:
    wrong = {"id": "a", "spans": [{"first": 1, "last": 4, "kinds": ["smile"]}]}
    span = "{'first': 1, 'last': 4, 'kinds': ['smile']}"
    assert problems_of(wrong, "head", 4) == ["no head smile", f"{span} out of range"]
    assert problems_of(SMILES, "face", 4) == []


@needs(DIRECTING)
@pytest.mark.parametrize("channel", KINDS)
def test_every_reading_is_of_a_known_line_and_three_read_what_nothing_is_trained_on(channel: str) -> None:
    lines, by_three = {line.name: line for line in [*read_lines(DIRECTING), *read_alike()]}, readings_by_three()
    readings = channel_readings(channel)
    assert len(readings) > 10_000
    for name, own in readings.items():
        assert [problems_of(each, channel, len(lines[name].words)) for each in own] == [[]] * len(own), name
        assert len(own) == 3 if name in by_three else len(own) in (1, 2), name
        assert name in by_three or name.startswith("alike") or not is_held_out(lines[name]), name


def test_of_lines_that_sound_alike_the_face_alone_was_read_and_it_tells_them_apart() -> None:
    lines, faces, heads = read_alike(), channel_readings("face"), channel_readings("head")
    assert len(lines) > 20_000
    assert len({line.words for line in lines}) == len({line.name for line in lines}) == len(lines)
    assert all(line.name in faces and line.name not in heads for line in lines)
    smiled_at = defaultdict(set)
    for line in lines:
        smiled_at[line.name[:-1]].add(any("smile" in span["kinds"] for span in faces[line.name][0]["spans"]))
    assert sum(len(smiles) == 2 for smiles in smiled_at.values()) > 0.5 * len(smiled_at)
