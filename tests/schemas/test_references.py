"""A speaker's reference is unchanged by writing and reading, and mistakes are reported on one line."""

import json
from pathlib import Path

import numpy as np
import pytest

from understudy.cli.main import main
from understudy.errors import InputError
from understudy.model.voice.signal import SpeakerReference
from understudy.schemas.options import read_options
from understudy.schemas.references import read_reference, to_json

AUDIO = [str(Path(__file__).parents[1] / "audio" / f"{name}.flac") for name in ("figure8", "numbers")]
REFERENCE = SpeakerReference("paper", 3, np.linspace(-1, 1, 12) / 3, np.linspace(0, 2, 12))


def test_what_is_written_is_read_to_the_last_bit() -> None:
    read = read_reference(to_json(REFERENCE), "ref.json")
    assert (read.feature_set, read.recordings) == ("paper", 3)
    assert read.mean.tolist() == REFERENCE.mean.tolist()
    assert read.deviation.tolist() == REFERENCE.deviation.tolist()


def test_options_take_the_same_object() -> None:
    options = read_options(json.dumps({"reference": json.loads(to_json(REFERENCE))}).encode())
    assert options.reference is not None
    assert options.reference.mean.tolist() == REFERENCE.mean.tolist()


@pytest.mark.parametrize(
    "change",
    [
        {"features": "other"},
        {"recordings": 0},
        {"recordings": 2.5},
        {"mean": []},
        {"mean": [1.0]},
        {"mean": [float("nan")] * 12},
        {"mean": ["1"] * 12},
        {"deviation": [-1.0] * 12},
        {"more": 1},
    ],
)
def test_a_wrong_reference_is_refused_at_either_door(change: dict[str, object]) -> None:
    wrong = {**json.loads(to_json(REFERENCE)), **change}
    with pytest.raises(InputError, match=r"^ref.json: ") as at_the_command_line:
        read_reference(json.dumps(wrong).encode(), "ref.json")
    assert at_the_command_line.value.code == "reference_unreadable"
    with pytest.raises(InputError) as in_a_request:
        read_options(json.dumps({"reference": wrong}).encode())
    assert (in_a_request.value.code, in_a_request.value.field) == ("value_wrong", "reference")


@pytest.mark.parametrize("content", [b"", b"[]", b"\xff", b"RIFF"])
def test_another_file_is_no_reference(content: bytes) -> None:
    with pytest.raises(InputError, match="understudy reference"):
        read_reference(content, "ref.json")


def test_a_kept_reference_judges_as_its_recordings_do(
    tmp_path: Path, capfdbinary: pytest.CaptureFixture[bytes]
) -> None:
    kept = str(tmp_path / "ref.json")
    assert main(["reference", *AUDIO, "-o", kept]) == 0
    told = []
    for reference in ([], ["--reference", kept], ["--reference", *AUDIO], ["--reference", AUDIO[0]]):
        assert main(["agitation", AUDIO[0], *reference]) == 0
        told.append(json.loads(capfdbinary.readouterr().out)["memberships"])
    assert told[1] == told[2]
    assert told[0] != told[1] != told[3]


def test_a_kept_reference_stands_alone(capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    assert main(["agitation", AUDIO[0], "--reference", AUDIO[1], "ref.json"]) == 2
    assert b"one .json alone" in capfdbinary.readouterr().err
