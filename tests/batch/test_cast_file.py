"""Reading cast.yaml, and every mistake in it with its place."""

from pathlib import Path

import pytest

from understudy.batch.casting import read_cast
from understudy.errors import AuthoringError
from understudy.model import Level, Target
from understudy.schemas.affect import read_affect

OURS = frozenset({"default", "expansive"})


def write(folder: Path, text: str) -> Path:
    path = folder / "cast.yaml"
    path.write_text(text, encoding="utf-8")
    return path


def test_what_a_cast_says(tmp_path: Path) -> None:
    reference = '{"features": "full", "recordings": 3, "mean": [0.5], "deviation": [1.0]}'
    (tmp_path / "ben.json").write_text(reference)
    cast = read_cast(
        write(
            tmp_path,
            "Mrs. O'Hara: {character: expansive, seed: 7, agitation: low, stillness: 0.5, listener: [BEN, Cat]}\n"
            "Dog: {target: {door: [1, 1.4, 2.0]}}\n"
            "BEN: {reference: ben.json, profile: sparing}\n"
            "'*': {reference: none}\n",
        ),
        OURS,
    )
    part = cast.part("MRS.  O'HARA")
    assert (part.character, part.seed, part.agitation, part.stillness) == ("expansive", 7, Level.LOW, 0.5)
    assert part.listeners == ("BEN", "Cat")
    assert part.is_learnt
    assert cast.part("dog").targets == (Target("door", (1.0, 1.4, 2.0)),)
    ben = cast.part("Ben")
    assert ben.reference is not None
    assert (ben.reference.recordings, ben.is_learnt) == (3, False)
    assert not cast.part("Dora").is_learnt
    assert ben.profile == "sparing"


def test_a_feeling_is_a_tone_numbers_or_a_track_beside_the_cast(tmp_path: Path) -> None:
    (tmp_path / "up.csv").write_text("time_s,activation,valence,dominance\n0,0,0,0\n2,0.8,0.1,0.2\n")
    text = "ANNA: {affect: sad}\nBEN: {affect: [0.5, -0.2, 0.1]}\nEVE: {affect: up.csv}\n'*': {}\n"
    cast = read_cast(write(tmp_path, text), OURS)
    assert cast.part("anna").affect == read_affect("sad")
    assert cast.part("ben").affect == read_affect("0.5,-0.2,0.1")
    track = cast.part("eve").affect
    assert track is not None
    assert track.times_s == (0.0, 2.0)
    assert cast.part("dora").affect is None


def test_a_wrong_feeling_is_told_with_its_place(tmp_path: Path) -> None:
    text = "ANNA:\n  seed: 1\n  affect: grumpy\nBEN:\n  affect: gone.csv\n"
    with pytest.raises(AuthoringError) as raised:
        read_cast(write(tmp_path, text), OURS)
    assert sorted(mistake.line for mistake in raised.value.mistakes) == [3, 5]


def test_every_mistake_is_told_with_its_place(tmp_path: Path) -> None:
    path = write(
        tmp_path,
        "ANNA:\n  character: expansiv\nanna:\n  reference: gone.json\nBEN:\n  target: {door: [1, 2, 5000]}\n"
        "EVE:\n  profile: sparin\n",
    )
    with pytest.raises(AuthoringError) as raised:
        read_cast(path, OURS)
    assert sorted(mistake.line for mistake in raised.value.mistakes) == [2, 4, 4, 6, 8]
    assert "did you mean 'expansive'" in raised.value.message


@pytest.mark.parametrize("text", ["ANNA: {seed: x}\n", "ANNA: {stillness: 2}\n", "ANNA: {carachter: default}\n"])
def test_what_no_part_can_have_is_refused(text: str, tmp_path: Path) -> None:
    with pytest.raises(AuthoringError) as raised:
        read_cast(write(tmp_path, text), OURS)
    assert [mistake.line for mistake in raised.value.mistakes] == [1]
