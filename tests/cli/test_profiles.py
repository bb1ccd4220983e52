"""`understudy profiles`: learning, mixing, listing, showing, and messages about mistakes."""

import json
import re
from dataclasses import replace
from pathlib import Path

import pytest

from tests.support.annotations import SPARING, SWEEPING
from understudy.cli.main import main
from understudy.models import load_characters, load_profile_file, profile_names
from understudy.profiles.annotation.reading import read_tracks
from understudy.profiles.annotation.tables import write_json_tracks
from understudy.profiles.annotation.tracks import Track, merged

Captured = pytest.CaptureFixture[bytes]


def _run(capture: Captured, *argv: str) -> tuple[int, str, str]:
    capture.readouterr()
    code = main(argv)
    out, err = capture.readouterr()
    return code, out.decode(), err.decode()


def test_learning_makes_the_profile_of_the_lexicon(capfdbinary: Captured, tmp_path: Path) -> None:
    target = tmp_path / "sweeping.yaml"
    shipped = load_profile_file(Path("lexicon/profiles/sweeping.yaml"), load_characters().gesture_lexemes)
    code, _, err = _run(
        capfdbinary, "profiles", "learn", str(SWEEPING), "--description", shipped.description, "-o", str(target)
    )
    assert code == 0
    assert "gestures a minute" in err
    assert target.read_bytes() == Path("lexicon/profiles/sweeping.yaml").read_bytes()


def test_tags_come_from_the_words_where_nobody_marked_them(capfdbinary: Captured, tmp_path: Path) -> None:
    source, target = tmp_path / "plain.json", tmp_path / "plain.yaml"
    tracks = [track for track in merged(read_tracks(SPARING)) if track.name != "tags"]
    source.write_bytes(write_json_tracks(tracks))
    code, _, _ = _run(capfdbinary, "profiles", "learn", str(source), "-o", str(target), "--quiet")
    assert code == 0
    profile = load_profile_file(target, load_characters().gesture_lexemes)
    assert {"negation", "deixis.self", "any"} <= profile.tags.keys()
    assert profile.gestures == 110


def test_little_annotation_and_tracks_of_other_names_are_told(capfdbinary: Captured, tmp_path: Path) -> None:
    source = tmp_path / "short.json"
    every = read_tracks(SWEEPING)
    end_s = next(track for track in every if track.name == "units").spans[4].end_s
    tracks = [replace(each, spans=tuple(span for span in each.spans if span.end_s <= end_s)) for each in every]
    comments = Track("comments", tracks[0].spans)
    source.write_bytes(write_json_tracks([*merged(tracks), comments]))
    code, _, err = _run(capfdbinary, "profiles", "learn", str(source), "-o", str(tmp_path / "short.yaml"))
    assert code == 0
    warnings = [line for line in err.splitlines() if line.startswith("warning: ")]
    assert f"{source}: tracks that are not read: comments" in warnings[0]
    assert "few to know a speaker well" in warnings[1]


def test_a_mixed_profile_can_be_mixed_again(capfdbinary: Captured, tmp_path: Path) -> None:
    first, second = tmp_path / "first.yaml", tmp_path / "second.yaml"
    assert _run(capfdbinary, "profiles", "mix", "sweeping", "sparing", "-o", str(first))[0] == 0
    assert _run(capfdbinary, "profiles", "mix", str(first), "sparing", "--share", "1", "-o", str(second))[0] == 0
    code, out, _ = _run(capfdbinary, "profiles", "show", str(second))
    assert code == 0
    assert out.startswith("second: 0% first, 100% sparing.")
    assert "14.8 gestures a minute" in out


def test_the_list_has_every_profile(capfdbinary: Captured) -> None:
    code, out, _ = _run(capfdbinary, "profiles", "list")
    assert code == 0
    assert tuple(line.split()[0] for line in out.splitlines()) == profile_names()


def test_mistakes_are_told(capfdbinary: Captured, tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.csv"
    wrong.write_text("track,start_s,end_s,label\nwords,1,0,I\nphrases,0,1,BEET\n", encoding="utf-8")
    for argv, told in (
        (("show", "sweep"), "did you mean 'sweeping'?"),
        (("mix", "sweeping", "sparing", "--share", "2"), "share: 2"),
        (("learn", str(wrong)), "words at 1.000 s: ends at 0.000 s"),
        (("learn", "missing.eaf"), "missing.eaf: cannot be read"),
    ):
        code, out, err = _run(capfdbinary, "profiles", *argv)
        assert (code, out) == (2, "")
        assert told in err


def test_perform_and_script_take_a_profile_by_name_or_file(capfdbinary: Captured, tmp_path: Path) -> None:
    line = ("examples/example.flac", "--text-file", "examples/example.txt", "--quiet")
    script, motion = tmp_path / "script.json", tmp_path / "out.bvh"
    assert _run(capfdbinary, "script", *line, "--profile", "lexicon/profiles/sparing.yaml", "-o", str(script))[0] == 0
    assert _run(capfdbinary, "realize", str(script), "-o", str(motion), "--quiet")[0] == 0
    assert motion.stat().st_size > 10_000
    told = json.loads(script.read_text())
    for gesture in told["gestures"]:
        gesture |= {"from": "XEP YLowerEP ZMiddle out", "to": "XOppP YUpperEP ZFar raised"}
    script.with_name("moved.json").write_text(json.dumps(told))
    moved = motion.with_name("moved.bvh")
    code, _, err = _run(capfdbinary, "realize", str(script.with_name("moved.json")), "-o", str(moved))
    assert code == 0
    assert "XOppP YUpperEP ZFar is" in err
    assert "cm out of reach" in err
    assert moved.read_bytes() != motion.read_bytes()
    code, out, _ = _run(capfdbinary, "perform", *line, "--profile", "sparing")
    assert code == 0
    lexemes = [each["lexeme"] for each in json.loads(script.read_text())["gestures"] if each["kept"]]
    assert lexemes
    assert re.findall(r'<gesture [^>]*lexeme="(\w+)"', out) == lexemes
    code, _, err = _run(capfdbinary, "perform", *line, "--profile", "spareing")
    assert code == 2
    assert "did you mean 'sparing'?" in err


def test_without_motion_there_are_empty_tracks_to_annotate(capfdbinary: Captured, tmp_path: Path) -> None:
    words, target = tmp_path / "words.json", tmp_path / "take.eaf"
    words.write_text('{"tracks": {"words": [{"start_s": 0.5, "end_s": 0.9, "text": "no"}], "phones": []}}')
    assert _run(capfdbinary, "profiles", "propose", "--words", str(words), "-o", str(target))[0] == 0
    tracks = {track.name: len(track.spans) for track in read_tracks(target)}
    asked = ("affiliate", "from", "hand", "path", "to")
    empty = ["phases", "phrases", "units", *(f"phrases.{name}" for name in asked)]
    assert tracks == {"words": 1, **dict.fromkeys(empty, 0)}
    code, _, err = _run(capfdbinary, "profiles", "propose", "-o", str(target))
    assert code == 2
    assert "give MOTION.bvh, --words FILE, or both" in err
