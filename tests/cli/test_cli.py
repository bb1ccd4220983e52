"""The command line: the outputs of each command, exit codes, and one line for every mistake."""

import io
import json
import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from understudy.cli.commands.perform import summary
from understudy.cli.files import write
from understudy.cli.log import Audience, Log
from understudy.cli.main import main
from understudy.errors import InputError
from understudy.model import (
    Agitation,
    Behavior,
    Channel,
    Function,
    Hand,
    Interval,
    Parse,
    Performance,
    SyncPoints,
    Utterance,
    Word,
)

Captured = pytest.CaptureFixture[bytes]

AUDIO_FOLDER = Path(__file__).parents[1] / "audio"
AUDIO = str(AUDIO_FOLDER / "figure8.flac")
TEXT_FILE = str(AUDIO_FOLDER / "figure8.txt")
TEXT = Path(TEXT_FILE).read_text(encoding="utf-8")
LINE = [AUDIO, "--text-file", TEXT_FILE]


def _run(capture: Captured, *argv: str) -> tuple[int, str, str]:
    """Exit code, standard output and standard error."""
    capture.readouterr()
    code = main(argv)
    out, err = capture.readouterr()
    return code, out.decode(), err.decode()


def _give(monkeypatch: pytest.MonkeyPatch, content: bytes) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(content)))


def test_a_performance_goes_to_its_files_and_is_told_on_standard_error(capfdbinary: Captured, tmp_path: Path) -> None:
    bml, trace = tmp_path / "out.bml", tmp_path / "out.json"
    bml.write_text("old")
    code, out, err = _run(capfdbinary, "perform", *LINE, "-o", str(bml), "--trace", str(trace), "--seed", "3")
    assert (code, out) == (0, "")
    assert b"<bml" in bml.read_bytes()
    told = json.loads(trace.read_bytes())
    assert told["seed"] == 3
    kept = [behavior for behavior in told["behaviors"] if behavior["kept"] and "function" in behavior]
    assert kept
    for behavior in kept:
        assert behavior["rule"] in err
    assert sorted(tmp_path.iterdir()) == [bml, trace]
    assert stat.S_IMODE(bml.stat().st_mode) == stat.S_IMODE(trace.stat().st_mode)

    code, out, err = _run(capfdbinary, "perform", *LINE, "--seed", "3", "--quiet")
    assert (code, out.encode(), err) == (0, bml.read_bytes(), "")


def test_an_analysis_in_json_with_its_stages_as_json_lines(capfdbinary: Captured) -> None:
    code, out, err = _run(capfdbinary, "--json-log", "analyze", AUDIO, "--text", TEXT, "--agitation", "high")
    assert code == 0
    told = json.loads(out)
    assert told.keys() >= {"audio", "words", "stress", "agitation", "parse", "functions", "warnings"}
    assert told["agitation"] == "high"
    events = [json.loads(line) for line in err.splitlines()]
    assert {"event": "stage", "stage": "parse"} in events


def test_a_feeling_that_is_given_replaces_the_one_heard(capfdbinary: Captured, tmp_path: Path) -> None:
    track = tmp_path / "track.csv"
    track.write_text("time_s,activation,valence,dominance\n0,0.6,-0.5,0.3\n", encoding="utf-8")
    for told, tone in (("sad", "sad"), ("-0.4,-0.6,-.3", "sad"), ("0.6,-0.5,0.3", "angry"), (str(track), "angry")):
        code, out, _ = _run(capfdbinary, "analyze", AUDIO, "--text", TEXT, "--affect", told)
        affect = json.loads(out)["affect"]
        assert (code, affect["given"]) == (0, True)
        assert max(affect["tones"], key=affect["tones"].get) == tone
    code, out, err = _run(capfdbinary, "analyze", AUDIO, "--text", TEXT, "--affect", "furious")
    assert (code, out) == (2, "")
    assert "neither a tone" in err


def test_an_analysis_is_drawn_beside_its_json(capfdbinary: Captured, tmp_path: Path) -> None:
    picture = tmp_path / "line.png"
    code, out, _ = _run(capfdbinary, "analyze", AUDIO, "--text", TEXT, "--plot", str(picture))
    assert (code, json.loads(out)["audio"].keys()) == (0, {"duration_s"})
    content = picture.read_bytes()
    width, height = (int.from_bytes(content[place : place + 4], "big") for place in (16, 20))
    assert content.startswith(b"\x89PNG")
    assert width > height > 500


def test_a_picture_that_is_no_png_is_refused_before_anything_is_heard(capfdbinary: Captured, tmp_path: Path) -> None:
    code, out, err = _run(capfdbinary, "analyze", AUDIO, "--text", TEXT, "--plot", str(tmp_path / "line.jpg"))
    assert (code, out) == (2, "")
    assert "plot_format" in err or ".png" in err


def test_alignments_in_three_formats_can_be_read_again(capfdbinary: Captured, tmp_path: Path) -> None:
    code, out, _ = _run(capfdbinary, "align", *LINE)
    words = json.loads(out)["words"]
    assert code == 0
    assert [word["text"] for word in words] == TEXT.split()
    for form in ("json", "textgrid", "ctm"):
        file = tmp_path / f"words.{form}"
        file.write_text(_run(capfdbinary, "align", *LINE, "--format", form)[1], encoding="utf-8")
        code, out, err = _run(capfdbinary, "align", *LINE, "--words", str(file))
        assert code == 0, err
        for word, again in zip(words, json.loads(out)["words"], strict=True):
            assert again["start_s"] == pytest.approx(word["start_s"], abs=0.002)


def test_pitch_has_a_row_every_10_ms(capfdbinary: Captured) -> None:
    code, out, _ = _run(capfdbinary, "pitch", AUDIO)
    header, *rows = out.splitlines()
    assert (code, header) == (0, "time_s,f0_hz,energy_db")
    assert [row.split(",")[0] for row in rows] == [f"{frame / 100:.2f}" for frame in range(len(rows))]


def test_agitation_is_told_line_by_line_and_the_wrong_file_is_named(capfdbinary: Captured, tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.wav"
    wrong.write_bytes(b"no sound")
    code, out, err = _run(capfdbinary, "agitation", AUDIO, AUDIO, str(wrong))
    assert code == 2
    lines = [json.loads(line) for line in out.splitlines()]
    assert [line["file"] for line in lines] == [AUDIO, AUDIO]
    assert lines[0]["agitation"] in {"low", "medium", "high"}
    assert sum(lines[0]["memberships"].values()) == pytest.approx(1, abs=1e-5)
    assert lines[0]["affect"].keys() == {"activation", "valence", "dominance", "tones"}
    assert sum(lines[0]["affect"]["tones"].values()) == pytest.approx(1, abs=1e-5)
    assert str(wrong) in err


def test_functions_line_by_line_in_order_wrong_ones_too(capfdbinary: Captured, monkeypatch: pytest.MonkeyPatch) -> None:
    _give(monkeypatch, b'{"id": 1, "text": "No."}\n\n{bad\n{"id": "x", "text": "\\u0007"}\n{"id": 2, "text": "Yes."}')
    code, out, err = _run(capfdbinary, "functions")
    answers = [json.loads(line) for line in out.splitlines()]
    assert [answer.get("id") for answer in answers] == [1, None, "x", 2]
    assert ["error" in answer for answer in answers] == [False, True, True, False]
    assert code == 2
    assert err.count("\n") == 1
    assert "line 3" in err


def test_a_line_is_answered_before_the_next_is_sent() -> None:
    command = [sys.executable, "-m", "understudy.cli", "functions"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdin
        assert process.stdout
        for number in range(2):
            process.stdin.write(b'{"id": %d, "text": "No."}\n' % number)
            process.stdin.flush()
            assert json.loads(process.stdout.readline())["id"] == number
        process.stdout.close()
        process.stdin.write(b'{"id": 3, "text": "Nobody listens."}\n')
        process.stdin.close()
        assert process.wait() == 0


def test_rules_are_checked_listed_and_explained(capfdbinary: Captured, tmp_path: Path) -> None:
    code, out, _ = _run(capfdbinary, "rules", "list", "--json")
    listed = json.loads(out)["rules"]
    assert code == 0
    assert {rule["kind"] for rule in listed} == {"function", "behavior", "bml", "word"}
    code, out, _ = _run(capfdbinary, "rules", "explain", listed[0]["name"])
    assert code == 0
    assert f"{listed[0]['file']}:{listed[0]['line']}" in out
    wrong = tmp_path / "wrong.rules"
    wrong.write_text("rule wrong\nforeach\n  fcnn(a, b)\nassert\n  fcn(a, b, $x, 1, 2)\n")
    code, out, err = _run(capfdbinary, "rules", "check", str(wrong))
    assert (code, out) == (2, "")
    assert f"{wrong}:3:3: " in err
    assert "^" in err
    assert f"{wrong}:5:" in err


def test_characters_are_listed_and_shown(capfdbinary: Captured) -> None:
    code, out, _ = _run(capfdbinary, "characters", "list")
    names = [line.split()[0] for line in out.splitlines()]
    assert code == 0
    assert "default" in names
    code, out, _ = _run(capfdbinary, "characters", "show", names[0])
    shown = json.loads(out)
    assert shown["name"] == names[0]
    assert {"height_m", "build"} < shown["body"].keys()


def test_characters_are_drawn(capfdbinary: Captured, tmp_path: Path) -> None:
    picture = tmp_path / "elder.png"
    code, _, err = _run(capfdbinary, "characters", "render", "formal_elder", "-o", str(picture))
    assert (code, err.decode() if isinstance(err, bytes) else err) == (0, f"1 characters in {picture}\n")
    assert picture.read_bytes().startswith(b"\x89PNG")


MISTAKES: list[tuple[list[str], str]] = [
    ([], "usage"),
    (["dance"], "usage"),
    (["perform", AUDIO], "usage"),
    (["perform", AUDIO, "--text", "a", "--text-file", TEXT_FILE], "usage"),
    (["perform", *LINE, "--agitation", "mid"], "usage"),
    (["perform", *LINE, "--seed", "many"], "usage"),
    (["perform", *LINE, "--see", "1"], "usage"),
    (["perform", *LINE, "-o", "a.bml", "-o", "b.bml"], "usage"),
    (["perform", *LINE, "--seed", "1", "--seed", "2"], "usage"),
    (["perform", "-", "--text-file", "-"], "usage"),
    (["perform", *LINE, "-o", "same.json", "--trace", "same.json"], "files_same"),
    (["perform", *LINE, "-o", "/nowhere/out.bml"], "file_unwritable"),
    (["perform", *LINE, "-o", "/"], "file_unwritable"),
    (["perform", "/nowhere/a.wav", "--text", "No."], "file_unreadable"),
    (["perform", "/", "--text", "No."], "file_unreadable"),
    (["perform", "nul\0.wav", "--text", "No."], "file_unreadable"),
    (["perform", AUDIO, "--text-file", AUDIO], "text_not_utf8"),
    (["perform", *LINE, "--words", TEXT_FILE], "timings_format"),
    (["align", AUDIO, "--text", " "], "text_empty"),
    (["align", AUDIO, "--text", "caf\udce9"], "text_surrogate"),
    (["align", TEXT_FILE, "--text", "No."], "audio_format_unsupported"),
    (["rules", "check", "/nowhere"], "no_authored_file"),
    (["rules", "explain", "no such rule"], "unknown_name"),
    (["characters", "show", "nobody"], "unknown_character"),
]


@pytest.mark.parametrize(("argv", "code"), MISTAKES, ids=[" ".join(argv)[:60] for argv, _ in MISTAKES])
def test_a_mistake_is_one_line_and_exit_code_2(argv: list[str], code: str, capfdbinary: Captured) -> None:
    exit_code, out, err = _run(capfdbinary, *argv, "--json-log")
    assert (exit_code, out) == (2, "")
    assert err.count("\n") == 1
    told = json.loads(err)
    assert (told["event"], told["code"]) == ("error", code)
    assert "\n" not in told["message"]


def test_a_mistake_for_people_names_the_program(capfdbinary: Captured) -> None:
    assert _run(capfdbinary, "dance")[2].startswith("understudy: ")
    assert _run(capfdbinary, "dance", "--quiet")[2].startswith("understudy: ")


def test_an_option_that_is_given_twice_is_named_with_what_to_do(capfdbinary: Captured) -> None:
    told = _run(capfdbinary, "perform", *LINE, "-o", "a.bml", "-o", "b.bml")[2]
    assert told == "understudy: -o is given twice; give it once; see understudy perform --help\n"


def test_a_wrong_choice_is_told_with_the_right_ones_as_they_are_typed(capfdbinary: Captured) -> None:
    told = _run(capfdbinary, "perform", *LINE, "--agitation", "mid")[2]
    assert "invalid choice: 'mid' (choose from 'low', 'medium', 'high')" in told


def test_a_wrong_setting_is_a_mistake(capfdbinary: Captured, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UNDERSTUDY_DEADLINE_S", "soon")
    code, _, err = _run(capfdbinary, "align", *LINE)
    assert code == 2
    assert "UNDERSTUDY_DEADLINE_S" in err


@pytest.mark.parametrize(("limit", "code"), [(os.path.getsize(AUDIO), 0), (os.path.getsize(AUDIO) - 1, 2)])
def test_the_limit_of_the_audio(limit: int, code: int, capfdbinary: Captured, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UNDERSTUDY_PART_BYTES", f"audio={limit}")
    assert _run(capfdbinary, "pitch", AUDIO)[0] == code


def test_writing_keeps_the_old_file_when_it_fails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    target = tmp_path / "out.bml"
    target.write_text("old")

    def fail(_self: Path, _content: bytes) -> int:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", fail)
    with pytest.raises(InputError) as caught:
        write(str(target), b"new")
    assert "No space left" in caught.value.message
    assert target.read_text() == "old"
    assert list(tmp_path.iterdir()) == [target]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is full")
def test_standard_output_on_a_full_disk_is_told_in_a_line() -> None:
    with Path("/dev/full").open("wb") as full:
        command = [sys.executable, "-m", "understudy.cli", "characters", "list"]
        run = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    told = "understudy: standard output: cannot be written: No space left on device\n"
    assert (run.returncode, run.stderr) == (2, told)


def test_writing_follows_links_and_leaves_devices_alone(tmp_path: Path) -> None:
    target, link = tmp_path / "real.bml", tmp_path / "link.bml"
    target.write_text("old")
    link.symlink_to(target)
    write(str(link), b"new")
    assert link.is_symlink()
    assert target.read_bytes() == b"new"
    write(os.devnull, b"new")
    assert not Path(os.devnull).is_file()


@pytest.mark.parametrize(
    ("argv", "voice"),
    [
        (["perform"], Audience.PEOPLE),
        (["perform", "--quiet"], Audience.QUIET),
        (["--json-log", "perform"], Audience.MACHINES),
    ],
)
def test_the_voice_is_found_wherever_it_stands(argv: list[str], voice: Audience) -> None:
    assert Log.for_arguments(argv).voice is voice


def test_the_summary_tells_what_is_shown_and_why() -> None:
    words = (Word(0, "Not", Interval(0.1, 0.3)), Word(1, "me.", Interval(0.4, 0.9)))
    functions = (
        Function("f1", "negation", "plain", 0, 0, 5.0, "negation_word"),
        Function("f2", "deixis", "self", 1, 1, 2.0, "personal_pronoun"),
    )
    point = Behavior("b2", Channel.GESTURE, "ME", SyncPoints(0.3, 1.0), 1, 1, 2.0, "show_self", "f2", Hand.LEFT)
    shake = Behavior("b1", Channel.HEAD, "SHAKE", SyncPoints(0.0, 0.5), 0, 0, 5.0, "show_negation", "f1")
    lost = Behavior("b3", Channel.HEAD, "NOD", SyncPoints(0.0, 0.5), 0, 0, 1.0, "other", "f1", kept=False)
    blink = Behavior("b4", Channel.EYES, "BLINK", SyncPoints(0.9, 1.0), 1, 1, 0.0)
    utterance = Utterance(words, Parse((), (), ()), Agitation(0.1, 0.2, 0.7), duration_s=1.2)
    told = summary(Performance(utterance, functions, (point, shake, lost, blink), "default", 0)).splitlines()
    assert "agitation high" in told[0]
    assert " ".join(told[1].split()) == "0.00– 0.50 s head shake Not negation by negation_word → show_negation"
    assert (
        " ".join(told[2].split()) == "0.30– 1.00 s gesture me (left) me. deixis (self) by personal_pronoun → show_self"
    )
    assert "1 × blink" in told[3]
    assert ": 1 " in told[4]
    assert len(told) == 5
