"""The statements of docs/engines.md about our files are true, and its commands are valid."""

import csv
import io
import re
import shlex
from pathlib import Path

import pytest

from tests.support.motion.gltf_reading import read
from tests.support.motion.hand_made_motion import BODY, waving
from understudy.cli.arguments.parser import make_parser
from understudy.model.formats import format_of
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.exporting.face_lists import to_arkit_csv
from understudy.realizer.exporting.glb import to_glb

PAGE = (Path(__file__).parents[2] / "docs" / "engines.md").read_text(encoding="utf-8")
COMMANDS = re.findall(r"(?:^ {4}|`)understudy ([^`\n]+)", PAGE, re.MULTILINE)


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_of_the_page_can_be_typed(command: str) -> None:
    arguments = make_parser().parse_args(shlex.split(command))
    written = arguments.output if arguments.command == "realize" else arguments.realize
    assert all(format_of(name) for name in written)


def test_the_glb_is_as_the_page_says() -> None:
    tree = read(to_glb(waving(), BODY)).tree
    joints = [tree["nodes"][joint] for joint in tree["skins"][0]["joints"]]
    assert [animation["name"] for animation in tree["animations"]] == ["performance"]
    assert len(joints) == 54
    assert {"hips", "leftUpperArm", "leftThumbMetacarpal", "upperChest", "leftEye"} <= {node["name"] for node in joints}
    assert not any("rotation" in node for node in joints)
    moved = {
        tree["nodes"][channel["target"]["node"]]["name"]
        for channel in tree["animations"][0]["channels"]
        if channel["target"]["path"] == "translation"
    }
    assert moved == {"hips"}
    face = next(tree["meshes"][node["mesh"]] for node in tree["nodes"] if node["name"] == "Face")
    names = face["extras"]["targetNames"]
    assert len(names) == 67
    assert set(SHAPES) < set(names)
    assert {"viseme_sil", "viseme_U"} < set(names)


def _imported_times_s(content: bytes, rate_hz: int | None) -> list[float]:
    """The times that Epic's Live Link Face Importer gives the frames, which are checked as it does. At no rate it takes
    60 if a timecode has a frame number above 30, else 30, as later versions do."""
    header, *rows = csv.reader(io.StringIO(content.decode()))
    assert header[:2] == ["Timecode", "BlendShapeCount"]
    assert {len(row) for row in rows} == {len(header)}
    codes = [[float(part) for part in row[0].split(":")] for row in rows]
    assert {len(code) for code in codes} == {4}
    rate = rate_hz or (60 if max(code[3] for code in codes) > 30 else 30)
    return [3600 * hours + 60 * minutes + seconds + frames / rate for hours, minutes, seconds, frames in codes]


@pytest.mark.parametrize(("rate_hz", "importer_hz"), [(60, 60), (60, None), (30, None)])
def test_unreals_importer_gives_the_csvs_frames_their_times(rate_hz: int, importer_hz: int | None) -> None:
    motion = waving(2.0, rate_hz)
    times_s = _imported_times_s(to_arkit_csv(motion, BODY), importer_hz)
    assert times_s == pytest.approx([frame / rate_hz for frame in range(len(motion.body.times_s))])


def test_at_30_frames_a_second_older_importers_would_play_it_too_fast() -> None:
    """Why the page says to leave the rate at 60."""
    times_s = _imported_times_s(to_arkit_csv(waving(2.0, 30), BODY), 60)
    assert times_s[15] == pytest.approx(0.25)
