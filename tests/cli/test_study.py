"""`understudy study`: makes clips and a page from lines, and tables from answers."""

import json
from pathlib import Path

import pytest

from understudy.cli.main import main
from understudy.files import resource_folder

MODES = ("semantic", "prosody", "random")

Captured = pytest.CaptureFixture[bytes]

RATED = "rater,line,condition,rating\n" + "".join(
    f"{rater},{line},{mode},{grade + rater % 2}\n"
    for rater in range(4)
    for line in ("one", "two")
    for mode, grade in (("semantic", 8), ("prosody", 3), ("random", 3))
)


def _run(capture: Captured, *argv: str) -> tuple[int, str, str]:
    capture.readouterr()
    code = main(argv)
    out, err = capture.readouterr()
    return code, out.decode(), err.decode()


def test_answers_become_tables_and_a_report(capfdbinary: Captured, tmp_path: Path) -> None:
    answers, report = tmp_path / "a.csv", tmp_path / "report.json"
    answers.write_text(RATED)
    code, out, err = _run(capfdbinary, "study", "score", str(answers), "-o", str(report))
    assert (code, err) == (0, "")
    assert "| semantic | 8.50" in out
    assert json.loads(report.read_text())["raters"] == 4
    code, again, _ = _run(capfdbinary, "study", "score", str(answers), "-o", str(tmp_path / "report.md"))
    assert (tmp_path / "report.md").read_text() == again == out


def test_every_mistake_of_answers_is_a_line_of_its_own(capfdbinary: Captured, tmp_path: Path) -> None:
    answers = tmp_path / "a.csv"
    answers.write_text(RATED.replace("one,semantic,8", "one,semantic,80").replace("two,random,3", "two,chance,3"))
    code, out, err = _run(capfdbinary, "study", "score", str(answers))
    assert (code, out) == (2, "")
    assert [line.split(": ")[0].removeprefix(str(tmp_path)) for line in err.splitlines()] == [
        "/a.csv:2:4",
        "/a.csv:7:3",
        "/a.csv:14:4",
        "/a.csv:19:3",
    ]


def test_a_report_of_another_kind_is_refused(capfdbinary: Captured, tmp_path: Path) -> None:
    code, _, err = _run(capfdbinary, "study", "score", str(tmp_path / "a.csv"), "-o", "report.pdf")
    assert code == 2
    assert "report.pdf: a report is written as .json or .md" in err


def test_a_study_is_made_of_a_folder_and_its_key_tells_the_clips(capfdbinary: Captured, tmp_path: Path) -> None:
    lines, out = tmp_path / "lines", tmp_path / "out"
    lines.mkdir()
    for name in ("example.flac", "example.txt"):
        (lines / name).write_bytes((resource_folder("examples") / name).read_bytes())
    code, _, err = _run(capfdbinary, "study", "make", str(lines), "--out", str(out), "--seed", "3")
    assert code == 0
    assert "example: gestures: semantic" in err
    rows = [line.split(",") for line in (out / "key.csv").read_text().splitlines()]
    assert [row[1:] for row in rows] == [["line", "condition"], *(["example", mode] for mode in MODES)]
    assert {path.stem for path in (out / "page" / "clips").glob("*.js")} > {row[0] for row in rows[1:]}
    assert (out / "page" / "index.html").is_file()
    made = {path.name for path in (out / "page" / "clips").iterdir()}
    assert _run(capfdbinary, "study", "make", str(lines), "--out", str(out), "--seed", "4")[0] == 0
    again = {path.name for path in (out / "page" / "clips").iterdir()}
    assert len(again) == len(made), "what another seed made is gone"
    assert not again & made


def _lines(folder: Path, *names: str) -> Path:
    """The bundled line under these names."""
    folder.mkdir()
    for name in names:
        for suffix in (".flac", ".txt"):
            content = (resource_folder("examples") / f"example{suffix}").read_bytes()
            (folder / f"{name}{suffix}").write_bytes(content)
    return folder


def test_ways_from_a_voice_to_motion_are_made_answered_and_scored(capfdbinary: Captured, tmp_path: Path) -> None:
    """As a researcher would, by the thesis' plan: each two ways twice and one clip twice, in seven rounds."""
    lines, out = _lines(tmp_path / "lines", "one"), tmp_path / "out"
    code, _, err = _run(capfdbinary, "study", "make", str(lines), "--out", str(out), "--compare", "ways")
    assert code == 0
    assert "7 rounds" in err
    assert "take 15 raters if it is large (d = 0.8), 34 if medium (0.5)" in err
    key = dict(row.split(",one,") for row in (out / "key.csv").read_text().splitlines()[1:])
    assert sorted(key.values()) == ["live", "offline", "offline", "random"]
    page = (out / "page" / "index.html").read_text(encoding="utf-8")
    plan = json.loads(page.partition('id="plan">')[2].partition("</script>")[0])
    shown = [tuple(sorted(key[clip] for clip in each["clips"])) for each in plan["lines"]]
    assert sorted(set(shown)) == [
        ("live", "offline"),
        ("live", "random"),
        ("offline", "offline"),
        ("offline", "random"),
    ]
    worth = {"offline": 1, "live": 0, "random": -1}
    answers = "rater,group,trial,a,b,preference\n"
    for rater in range(6):
        for trial, (a, b) in enumerate(each["clips"] for each in plan["lines"]):
            liked = worth[key[b]] - worth[key[a]] if rater < 5 else 0
            answers += f"{rater},{'US' if rater % 2 else 'DE'},{trial},{a},{b},{liked}\n"
    (out / "answers.csv").write_text(answers)
    report = tmp_path / "report.json"
    code, told, err = _run(capfdbinary, "study", "score", str(out / "answers.csv"), "-o", str(report))
    assert (code, err) == (0, "")
    assert "| offline versus random | 12      | -1.67" in told
    assert "| offline twice" in told
    assert "Groups of raters (Mann-Whitney)" in told
    pairs = {(each["first"], each["second"]): each for each in json.loads(report.read_text())["pairs"]}
    assert pairs["offline", "random"]["mean"] == pytest.approx(-10 / 6)
    assert pairs["offline", "live"]["test"]["t"] == pytest.approx(-5.0)


def test_speakers_are_made_and_their_recognition_is_scored(capfdbinary: Captured, tmp_path: Path) -> None:
    lines, out = _lines(tmp_path / "lines", "one", "two"), tmp_path / "out"
    code, _, err = _run(capfdbinary, "study", "make", str(lines), "--out", str(out), "--compare", "speakers")
    assert code == 0, err
    rows = [row.split(",") for row in (out / "key.csv").read_text().splitlines()[1:]]
    clips = {condition: clip for clip, line, condition in rows if line == "two"}
    answers = "rater,clip,beside,answer\n" + "".join(
        f"{rater},{clips['sparing']},,{'sparing' if rater < 7 else 'sweeping'}\n"
        f"{rater},{clips['sweeping']},{clips['sparing']},sweeping\n"
        for rater in range(10)
    )
    (out / "answers.csv").write_text(answers)
    code, told, err = _run(capfdbinary, "study", "score", str(out / "answers.csv"))
    assert (code, err) == (0, "")
    assert "| 1, seen alone   | 10      | 70 %  | 50 %" in told
    assert "| 2, side by side | 10      | 100 %" in told


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--profile", "sweeping"), "leave it out, or --compare units"),
        (("--motion-model", "default"), "only --compare ways"),
        (("--compare", "speakers", "--profile", "sweeping"), "give two profiles"),
        (("--compare", "affect", "--motion-model", "none.npz"), "none.npz: cannot be read"),
        (("--compare", "units", "--profile", "nobody"), "nobody"),
        (("--character", "nobody"), "nobody"),
        ((), "no recordings in it"),
    ],
)
def test_a_study_that_cannot_be_made_says_why(
    capfdbinary: Captured, tmp_path: Path, arguments: tuple[str, ...], told: str
) -> None:
    code, _, err = _run(capfdbinary, "study", "make", str(tmp_path), "--out", str(tmp_path / "out"), *arguments)
    assert code == 2
    assert told in err
    assert not (tmp_path / "out").exists()


def test_lines_in_which_nothing_differs_are_no_study(capfdbinary: Captured, tmp_path: Path) -> None:
    """The profile that gestures one at a time has no unit of several in a line of seven seconds."""
    lines = tmp_path / "lines"
    lines.mkdir()
    for name in ("example.flac", "example.txt"):
        (lines / name).write_bytes((resource_folder("examples") / name).read_bytes())
    made = ("study", "make", str(lines), "--out", str(tmp_path / "out"), "--compare", "units", "--profile", "sparing")
    code, _, err = _run(capfdbinary, *made)
    assert code == 2
    assert "both versions are the same: left out" in err
    assert "the conditions differ visibly in no line; take lines of 11 to 28 s" in err
    assert not (tmp_path / "out").exists()
