"""A performance that begins before its recording, through every interface: the same line, later, with time for its
start."""

import io
import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
import soundfile
from fastapi.testclient import TestClient
from lxml import etree

from tests.support.bml.bml_checker import check
from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.bml.writing.writer import write_bml
from understudy.cli.main import main
from understudy.errors import InputError
from understudy.model import Behavior, Channel, GivenFunction, Line, Performance, Timings
from understudy.model.formats import BmlForm, DialectName, TimeForm
from understudy.model.limits import LATEST_S
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import BmlInput, RealizedSchedule, prepare_schedule, realize, schedule_of, write_motion
from understudy.realization import MotionFormat as Format
from understudy.settings import Settings

AUDIO_FOLDER = Path(__file__).parents[1] / "audio"
AUDIO = AUDIO_FOLDER / "figure8.flac"
TEXT = (AUDIO_FOLDER / "figure8.txt").read_text(encoding="utf-8")
LEAD_IN_S = 1.25
FORMS = [BmlForm(dialect, timing) for dialect in DialectName for timing in TimeForm]


@pytest.fixture(scope="module")
def trimmed(understudy: Understudy) -> Line:
    """The line as cut out of a film: it begins with its first sound."""
    heard = perform(understudy, Line(AUDIO.read_bytes(), TEXT), Options())
    first = heard.utterance.words[0].interval
    assert first is not None
    samples, rate = soundfile.read(AUDIO, dtype="int16")
    cut = round(first.start_s * rate)
    content = io.BytesIO()
    soundfile.write(content, samples[cut:], rate, format="FLAC")
    times = [
        {"text": word.text, "start_s": word.interval.start_s - cut / rate, "end_s": word.interval.end_s - cut / rate}
        for word in heard.utterance.words
        if word.interval
    ]
    return Line(content.getvalue(), TEXT, Timings(json.dumps({"words": times}).encode(), "json"))


@pytest.fixture(scope="module")
def led_in(understudy: Understudy, trimmed: Line) -> Performance:
    return perform(understudy, trimmed, Options(lead_in_s=LEAD_IN_S))


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        yield client


def _too_early(performance: Performance) -> list[Behavior]:
    """What the start of the recording takes time from."""
    hurried = (each for each in performance.behaviors if each.kind in (Channel.GESTURE, Channel.HEAD))
    return [each for each in hurried if "begins with the hand raised" in (each.reason or "")]


def test_the_words_and_the_recording_are_later_and_nothing_is_hurried(
    understudy: Understudy, trimmed: Line, led_in: Performance
) -> None:
    plain = perform(understudy, trimmed, Options())
    for before, after in zip(plain.utterance.words, led_in.utterance.words, strict=True):
        assert before.interval is not None
        assert after.interval is not None
        assert after.interval.start_s == pytest.approx(before.interval.start_s + LEAD_IN_S)
    assert (plain.utterance.lead_in_s, led_in.utterance.lead_in_s) == (0.0, LEAD_IN_S)
    assert plain.functions == led_in.functions
    assert not _too_early(led_in)
    assert all(each.sync.start >= 0 for each in led_in.behaviors)


@pytest.mark.parametrize("form", FORMS, ids=lambda form: f"{form.dialect}-{form.timing}")
def test_any_bml_of_it_is_read_as_it_was_performed(
    understudy: Understudy, trimmed: Line, led_in: Performance, form: BmlForm
) -> None:
    bml = write_bml(led_in, form)
    if form.dialect is DialectName.BML:
        assert check(bml) == []
    [speech] = etree.fromstring(bml).iter("{*}speech")
    assert float(speech.get("start", "")) == LEAD_IN_S
    direct = schedule_of(led_in)
    prepared = prepare_schedule(understudy.acoustic, BmlInput(bml, Path("a.bml"), trimmed.audio)).schedule
    assert prepared.lead_in_s == direct.lead_in_s == LEAD_IN_S
    heard = zip(prepared.words, direct.words, strict=True)
    assert all(abs(a.interval.start_s - b.interval.start_s) < 0.1 for a, b in heard if a.interval and b.interval)
    assert prepared.visemes[-1].interval.end_s == pytest.approx(direct.duration_s, abs=0.1)
    if form.timing is TimeForm.ABSOLUTE:
        gestures = {each.id: each for each in prepared.behaviors if each.kind is Channel.GESTURE}
        assert gestures
        for each in direct.behaviors:
            if each.kind is Channel.GESTURE:
                assert gestures[each.id].sync.stroke == pytest.approx(each.sync.stroke, abs=2e-3)


def test_smartbodys_marks_are_in_the_time_of_the_speech(led_in: Performance) -> None:
    bml = etree.fromstring(write_bml(led_in, BmlForm(DialectName.SMARTBODY)))
    marks = [float(sync.get("time", "")) for sync in bml.iter("sync")]
    ends = [word.interval.end_s for word in led_in.utterance.words if word.interval]
    assert marks[0] == pytest.approx(0.0, abs=0.01)
    assert marks[-1] == pytest.approx(ends[-1] - LEAD_IN_S, abs=2e-3)


def test_what_comes_before_the_speech_is_told_from_its_start(led_in: Performance) -> None:
    bml = write_bml(led_in, BmlForm(timing=TimeForm.SYNC))
    assert b'start="speech1:start - ' in bml or b'start="speech1:start-' in bml


def test_the_motion_is_as_long_as_both_and_tells_where_the_audio_goes(
    understudy: Understudy, led_in: Performance
) -> None:
    schedule = schedule_of(led_in)
    motion = realize(understudy.realizer, schedule, frame_rate_hz=30)
    assert led_in.utterance.duration_s is not None
    assert motion.duration_s >= led_in.utterance.duration_s - 1 / 30
    clip = json.loads(write_motion(RealizedSchedule(schedule, motion), understudy.realizer, Format.JSON))
    assert clip["audio_offset_s"] == -LEAD_IN_S
    jaw = clip["visemes"]
    spoken = [name for name, track in jaw.items() if name != "sil" and max(track[: int(30 * (LEAD_IN_S - 0.3))]) > 0.02]
    assert spoken == []


def test_a_hand_that_cannot_be_raised_in_time_is_raised_in_the_first_frame(
    understudy: Understudy, trimmed: Line
) -> None:
    """ "I" is the first sound, so that a gesture on it has no time at all."""
    myself = GivenFunction("deixis", "self", 0, 0)
    performance = perform(understudy, replace(trimmed, functions=(myself,)), Options(character="expansive"))
    [gesture] = [each for each in _too_early(performance) if each.kept]
    assert (gesture.lexeme, gesture.sync.start, gesture.sync.ready) == ("ME", 0.0, 0.0)
    motion = realize(understudy.realizer, schedule_of(performance), frame_rate_hz=30)
    realized = motion.realized[gesture.id]
    assert realized.stroke is not None
    assert gesture.sync.stroke is not None
    assert realized.stroke - gesture.sync.stroke <= LATEST_S


def _form(audio: bytes, lead_in: str) -> dict[str, tuple[str | None, str | bytes]]:
    return {"audio": ("a.flac", audio), "text": (None, TEXT), "options": (None, f'{{"lead_in_s": {lead_in}}}')}


def test_over_http(client: TestClient) -> None:
    form = _form(AUDIO.read_bytes(), "1")
    answer = client.post("/perform", files=form, headers={"Accept": "application/json"}).json()
    told = answer["performance"]
    assert told["lead_in_s"] == 1
    assert told["audio"]["duration_s"] == pytest.approx(soundfile.info(AUDIO).duration, abs=1e-3)
    assert told["words"][0]["start_s"] > 1
    assert '<speech id="speech1" start="1.000"' in answer["bml"]


@pytest.mark.parametrize("wrong", ["3.01", "-1", "NaN", '"1"'])
def test_over_http_a_wrong_one_is_told(client: TestClient, wrong: str) -> None:
    told = client.post("/perform", files=_form(b"", wrong)).json()
    assert (told["status"], told["code"], told["field"]) == (422, "value_wrong", "lead_in_s")


def test_on_the_command_line(capfdbinary: pytest.CaptureFixture[bytes], tmp_path: Path) -> None:
    line = [str(AUDIO), "--text", TEXT.strip()]
    target, trace = tmp_path / "a.bml", tmp_path / "a.json"
    assert main(["perform", *line, "--lead-in", "0.5", "-o", str(target), "--trace", str(trace)]) == 0
    assert json.loads(trace.read_bytes())["lead_in_s"] == 0.5
    assert "the recording begins at 0.50 s" in capfdbinary.readouterr().err.decode()
    for wrong in ("4", "-0.1", "nan"):
        assert main(["perform", *line, "--lead-in", wrong, "-o", str(target)]) == 2


def test_it_is_checked_where_it_is_given() -> None:
    with pytest.raises(InputError) as caught:
        Options(lead_in_s=3.5)
    assert (caught.value.code, caught.value.field) == ("value_wrong", "lead_in_s")
