"""Mistakes in arguments and files are reported before spaCy, the aligner or librosa is loaded; and no command loads
what it does not use."""

import json
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import pytest

AUDIO_FOLDER = Path(__file__).parents[2] / "audio"
AUDIO = str(AUDIO_FOLDER / "figure8.flac")
TEXT_FILE = str(AUDIO_FOLDER / "figure8.txt")
LINE = (AUDIO, "--text-file", TEXT_FILE)
BML = '<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="b"><head id="h" lexeme="NOD" stroke="1.0"/></bml>'

LARGE = {
    *("spacy", "pocketsphinx", "librosa", "numba", "sklearn", "matplotlib"),
    *("scipy.fft", "scipy.ndimage", "scipy.optimize"),
}
WATCHED = (*sorted(LARGE), "lark")
REALIZER = "understudy.realizer.realizing"
HEARING, PARSER, RULES = "understudy.acoustic.stage", "understudy.syntax", "understudy.rules"
STAGES = (HEARING, PARSER, RULES)


FORKING = """
import contextlib, io, json, os, sys
from understudy.cli.main import main
for line in sys.stdin:
    folder, argv, watched = json.loads(line)
    if os.fork():
        os.wait()
        continue
    os.chdir(folder)
    told = io.StringIO()
    with contextlib.redirect_stdout(io.TextIOWrapper(io.BytesIO())), contextlib.redirect_stderr(told):
        ended = main(["--json-log", *argv])
    errors = [json.loads(line)["code"] for line in told.getvalue().splitlines() if '"error"' in line]
    print(json.dumps([ended, (errors or [""])[0], sorted({*watched} & {*sys.modules})]), flush=True)
    os._exit(0)
"""
"""Runs each command in a process that has loaded what every command loads, and no more."""

Run = Callable[..., tuple[int, str, set[str]]]


@pytest.fixture(scope="module")
def loaded_by() -> Iterator[Run]:
    """Runs a command in a folder: the exit code, the error's code, and what of `WATCHED` is loaded when it ends."""
    with subprocess.Popen(
        [sys.executable, "-c", FORKING], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdin
        assert process.stdout
        asked, answers = process.stdin, process.stdout

        def run(*argv: str, cwd: Path) -> tuple[int, str, set[str]]:
            print(json.dumps([str(cwd), argv, (*WATCHED, REALIZER, *STAGES)]), file=asked, flush=True)
            ended, code, loaded = json.loads(answers.readline())
            return ended, code, {*loaded}

        yield run
        asked.close()


@pytest.fixture(scope="module")
def kept(loaded_by: Run, folder: Path) -> None:
    """What the first run makes and all others find, for which lark and librosa are loaded."""
    loaded_by("perform", *LINE, "--realize", "first.bvh", cwd=folder)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    tmp_path = tmp_path_factory.mktemp("early")
    (tmp_path / "line.bml").write_text(BML)
    (tmp_path / "words.json").write_text('{"words": [{"text": "other", "start_s": 0, "end_s": 1}]}')
    (tmp_path / "functions.json").write_text('[{"class": "negotiation", "subtype": "plain", "first": 0, "last": 0}]')
    (tmp_path / "outside.json").write_text('[{"class": "negation", "subtype": "plain", "first": 90, "last": 99}]')
    (tmp_path / "broken.json").write_text("{")
    (tmp_path / "no.flac").write_bytes(Path(AUDIO).read_bytes()[:60])
    return tmp_path


@pytest.mark.parametrize(
    ("argv", "code"),
    [
        (("perform", *LINE, "--character", "nobody"), "unknown_character"),
        (("perform", *LINE, "--realize", "a.bvh", "--skeleton", "nobody"), "unknown_skeleton"),
        (("perform", *LINE, "--realize", "a.glb", "--avatar", "nowhere.vrm"), "file_unreadable"),
        (("perform", *LINE, "--realize", "a.xyz"), "motion_format"),
        (("perform", *LINE, "--words", "nowhere.json"), "file_unreadable"),
        (("perform", *LINE, "--words", "words.json"), "timings_words_differ"),
        (("perform", *LINE, "--functions", "nowhere.json"), "file_unreadable"),
        (("perform", *LINE, "--functions", "broken.json"), "not_json"),
        (("perform", *LINE, "--functions", "functions.json"), "functions_class"),
        (("perform", *LINE, "--functions", "outside.json"), "functions_span"),
        (("perform", *LINE, "--reference", "nowhere.flac"), "file_unreadable"),
        (("perform", *LINE, "--reference", "broken.json"), "reference_unreadable"),
        (("perform", *LINE, "-o", "nowhere/a.bml"), "file_unwritable"),
        (("perform", *LINE, "--direction", "nowhere.json"), "file_unreadable"),
        (("perform", *LINE, "--direction", "broken.json"), "not_json"),
        (("perform", *LINE, "--lead-in", "9"), "value_wrong"),
        (("realize", "line.bml", "-o", "a.bvh", "--stillness", "2"), "value_wrong"),
        (("perform", "no.flac", "--text", "No."), "audio_undecodable"),
        (("perform", AUDIO, "--text", " "), "text_empty"),
        (("analyze", *LINE, "--functions", "functions.json"), "functions_class"),
        (("align", *LINE, "--words", "words.json"), "timings_words_differ"),
        (("functions", "--text", ""), "text_empty"),
        (("agitation", AUDIO, "nowhere.flac"), "file_unreadable"),
        (("realize", "line.bml", "-o", "a.bvh", "--skeleton", "nobody"), "unknown_skeleton"),
        (("realize", "line.bml", "-o", "a.glb", "--avatar", "nowhere.vrm"), "file_unreadable"),
        (("realize", "nowhere.bml", "-o", "a.glb"), "file_unreadable"),
    ],
)
def test_what_is_wrong_is_told_before_anything_large_is_loaded(
    argv: Sequence[str], code: str, loaded_by: Run, folder: Path
) -> None:
    ended, told, loaded = loaded_by(*argv, cwd=folder)
    assert (ended, told) == (2, code)
    assert loaded & LARGE == set()
    assert REALIZER not in loaded


@pytest.mark.parametrize(
    ("argv", "used"),
    [
        (("functions", "--text", "No, never."), {"spacy"}),
        (("rules", "check"), set()),
        (("gestures", "list"), set()),
        (("characters", "list"), set()),
        (("realize", "line.bml", "-o", "a.bvh"), {REALIZER}),
        (("pitch", AUDIO), set()),
        (("perform", *LINE), {"spacy", "pocketsphinx"}),
    ],
)
@pytest.mark.usefixtures("kept")
def test_a_command_loads_what_it_uses(argv: Sequence[str], used: set[str], loaded_by: Run, folder: Path) -> None:
    ended, told, loaded = loaded_by(*argv, cwd=folder)
    assert (ended, told) == (0, "")
    assert loaded - {*STAGES} == used


@pytest.mark.usefixtures("kept")
def test_to_play_bml_neither_parser_nor_rules_are_loaded_and_what_hears_only_for_a_recording(
    loaded_by: Run, folder: Path
) -> None:
    assert {*STAGES} & loaded_by("realize", "line.bml", "-o", "a.bvh", cwd=folder)[2] == set()
    with_audio = loaded_by("realize", "line.bml", "--audio", AUDIO, "-o", "a.bvh", cwd=folder)[2]
    assert HEARING in with_audio
    assert with_audio & {PARSER, "spacy"} == set()
