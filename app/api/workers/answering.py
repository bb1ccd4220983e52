"""Answers requests in a worker: parses the body within the limits of each field, then performs, realizes or analyses.
Everything here may be slow, use much memory or fail; none of it runs in the service's own process.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path, PurePath
from types import MappingProxyType

from ...authoring.rule_edits import Edits, rules_wrong, with_edits
from ...errors import AuthoringError, InputError, UnsupportedFormatError
from ...library.language import find_functions
from ...library.motion import (
    AvatarOptions,
    BmlInput,
    PreparedSchedule,
    RealizedSchedule,
    prepare_schedule,
    realize_prepared,
    write_realized,
)
from ...library.motion_checks import require_writer
from ...library.performing import PerformedLine
from ...library.writing import write_bml_files
from ...model import Line, Notice
from ...model.formats import AudioFile
from ...model.targets import targets_of
from ...models import Understudy
from ...option_table import MOTION
from ...options import Options
from ...schemas.direction import read_direction
from ...schemas.edits import read_edits
from ...schemas.options import RealizeOptions, read_options, read_realize_options
from ...schemas.requests import read_functions, read_object, read_request, read_timings, spoken_line
from ...schemas.responses import FunctionsResponse, PerformResponse
from ...schemas.rules import read_rule_part
from ..bodies import BML_TYPES, form_limits, media_type_of
from ..negotiation import JSON, MOTION_TYPES, XML, chosen
from . import authoring
from .form import FormPart, read_form, with_profile, with_reference
from .known_lines import KnownLines
from .messages import Answer, Job, Task

WARNINGS_HEADER = "Understudy-Warnings"


def answered(understudy: Understudy, job: Job, content: bytes, known: KnownLines) -> tuple[Answer, bytes]:
    """The answer to a request, and its body; `known` are the lines performed before, with the same models. Raises
    UnderstudyError."""
    if job.task is Task.PERFORM:
        return _performed(understudy, job, content, known)
    return _ANSWERS[job.task](understudy, job, content)


def _performed(understudy: Understudy, job: Job, content: bytes, known: KnownLines) -> tuple[Answer, bytes]:
    form = read_form(job.content_type, content, form_limits(Task.PERFORM, understudy.acoustic.settings))
    line = _line(form)
    options = with_profile(_options(form, understudy), form.get("profile"), understudy)
    options = with_reference(options, form.get("reference"), understudy)
    offered = (JSON,) if options.listeners else (XML, JSON)
    media_type = chosen(job.accept, offered, "a performance with listeners" if options.listeners else "a performance")
    edits = read_rule_part(form["rules"].content) if "rules" in form else {}
    performed = _performance(understudy, line, options, edits, known)
    performance = performed.performance
    files = write_bml_files(performance, options.form)
    if media_type == XML:
        left_out = [files.speech.left_out] if files.speech else []
        return Answer(media_type, _headers((*performance.notices, *left_out))), files.speaker
    heard = performed.analysis.heard
    contours = heard.contours if options.contours and heard else None
    body = PerformResponse.of(performance, files.speaker, files.listeners, files.speech, contours).to_json()
    return Answer(media_type, _headers(performance.notices)), body


def _performance(
    understudy: Understudy, line: Line, options: Options, edits: Edits, known: KnownLines
) -> PerformedLine:
    """The analysis and the performance by the rules with these edits.

    Raises InputError `rules_wrong`, also for a rule that goes wrong where it runs.
    """
    try:
        return known.performed(with_edits(understudy, edits), line, options, edits)
    except AuthoringError as error:
        if not edits:
            raise
        raise rules_wrong(error) from None


def _line(form: Mapping[str, FormPart]) -> Line:
    """Raises InputError `field_missing`, and what the parts' own checks raise."""
    if "text" not in form:
        message = "the field text is missing; send audio and text, or text alone for a line without a recording"
        raise InputError("field_missing", message, field="text")
    words = form.get("words")
    timings = None if words is None else read_timings(words.file_name or "", words.content)
    functions = read_functions(form["functions"].content) if "functions" in form else ()
    direction = read_direction(form["direction"].content) if "direction" in form else None
    if "audio" not in form:
        return spoken_line(form["text"].text, timings, functions, direction)
    return Line(form["audio"].content, form["text"].text, timings, functions, direction)


def _options(form: Mapping[str, FormPart], understudy: Understudy) -> Options:
    """The options, changed by an author's edits; the recording is named after its file."""
    options = _read_options(form["options"].content, understudy) if "options" in form else Options()
    if "edits" in form:
        options = options.with_edits(read_edits(form["edits"].content))
    audio_file = PurePath(form["audio"].file_name or "").name or None if "audio" in form else None
    return replace(options, form=replace(options.form, audio_file=audio_file))


def _read_options(content: bytes, understudy: Understudy) -> Options:
    """The options; if some are wrong, an unknown character, usually found later, is reported with them."""
    try:
        return read_options(content)
    except InputError as error:
        name = read_object(content, "options").get("character") if error.code == "value_wrong" else None
        if isinstance(name, str):
            try:
                understudy.behavior.characters.named(name)
            except InputError as unknown:
                raise InputError(error.code, f"{error.message}; {unknown.message}", field=error.field) from None
        raise


@dataclass(frozen=True, slots=True)
class _MotionRequest:
    """BML to be realized, the options, the avatar and the audio."""

    sheet: BmlInput
    question: RealizeOptions
    avatar: bytes | None = None
    audio: AudioFile | None = None
    motion_model: str | None = None
    scenario: str | None = None


def _realized(understudy: Understudy, job: Job, content: bytes) -> tuple[Answer, bytes]:
    """The motion in the requested format."""
    media_type = chosen(job.accept, tuple(MOTION_TYPES), "motion")
    require_writer(MOTION_TYPES[media_type])
    asked = _asked(understudy, job, content)
    question, realizer = asked.question, understudy.realizer
    if asked.scenario and not asked.motion_model:
        raise InputError("value_wrong", "scenario: drives a motion model; send motion_model too", field="scenario")
    MOTION["tail_s"].check(question.tail_s)
    if question.skeleton:
        realizer.rig(question.skeleton)
    staged = prepare_schedule(
        understudy.acoustic,
        asked.sheet,
        agitation=question.agitation,
        character=question.character,
        stillness=question.stillness,
        targets=targets_of(question.targets),
        seed=question.seed,
    )
    limits = understudy.acoustic.settings.motion_limits
    limits.check(staged.schedule, frame_rate_hz=question.fps, tail_s=question.tail_s)
    realized = _moved_by_model(understudy, asked, staged) if asked.motion_model else _moved(understudy, asked, staged)
    wearer = AvatarOptions(question.skeleton, asked.avatar)
    files = replace(question.files, audio=asked.audio)
    body = write_realized(realized, realizer, MOTION_TYPES[media_type], wearer, files)
    limits.check_content(body)
    return Answer(media_type, _headers(realized.motion.notices)), body


def _moved(understudy: Understudy, asked: _MotionRequest, staged: PreparedSchedule) -> RealizedSchedule:
    question = asked.question
    physics = understudy.acoustic.settings.physics if question.physics is None else question.physics
    return realize_prepared(
        understudy.realizer, staged, frame_rate_hz=question.fps, tail_s=question.tail_s, physics=physics
    )


def _moved_by_model(understudy: Understudy, asked: _MotionRequest, staged: PreparedSchedule) -> RealizedSchedule:
    """The motion by a motion model, which hears the recording. Raises InputError `motion_model`, `value_wrong`,
    `field_missing`."""
    from ...library import motion_models  # imported late: few requests need it

    question, settings = asked.question, understudy.acoustic.settings
    if asked.sheet.audio is None:
        message = "the field audio is missing; a motion model moves a body to a recording's voice"
        raise InputError("field_missing", message, field="audio")
    if question.physics:
        message = "physics: a motion model plays recorded motion; leave one of the two out"
        raise InputError("value_wrong", message, field="physics")
    model = motion_models.motion_model_named(asked.motion_model or motion_models.DEFAULT_MODEL, settings)
    scenario = motion_models.scenario_named(asked.scenario or motion_models.DEFAULT_SCENARIO)
    moving = motion_models.moving_by_recording(model, asked.sheet.audio, settings, scenario)
    return motion_models.realize_moving(
        understudy.realizer, staged, moving, frame_rate_hz=question.fps, tail_s=question.tail_s
    )


def _asked(understudy: Understudy, job: Job, content: bytes) -> _MotionRequest:
    """Raises InputError `field_missing`, UnsupportedFormatError `media_type`, and what the form's own checks raise."""
    limits, sent = understudy.acoustic.settings.motion_limits, media_type_of(job.content_type)
    if sent in BML_TYPES:
        return _MotionRequest(BmlInput(content, Path("bml"), limits=limits), RealizeOptions())
    if sent != "multipart/form-data":
        raise UnsupportedFormatError("media_type", f"send BML as {XML}, or multipart/form-data with bml and audio")
    form = read_form(job.content_type, content, form_limits(Task.REALIZE, understudy.acoustic.settings))
    if "bml" not in form:
        raise InputError("field_missing", "the field bml is missing; send the BML that is to be played", field="bml")
    parts = {name: part.content for name, part in form.items()}
    question = read_realize_options(parts["options"]) if "options" in parts else RealizeOptions()
    sheet = BmlInput(parts["bml"], Path(form["bml"].file_name or "bml"), parts.get("audio"), limits)
    name = PurePath(form["audio"].file_name or "").name if "audio" in form else ""
    audio = AudioFile(name, parts["audio"]) if name else None
    model, scenario = (form[name].text if name in form else None for name in ("motion_model", "scenario"))
    return _MotionRequest(sheet, question, parts.get("avatar"), audio, model, scenario)


def _understood(understudy: Understudy, job: Job, content: bytes) -> tuple[Answer, bytes]:
    """The communicative functions of a text."""
    if media_type_of(job.content_type) != JSON:
        raise UnsupportedFormatError("media_type", f'send {JSON}: {{"text": "…"}}')
    question = read_request(read_object(content, "body"))
    analysis = find_functions(understudy.language, question.text)
    return Answer(JSON), FunctionsResponse.of(analysis, question.id).to_json()


_ANSWERS: Mapping[Task, Callable[[Understudy, Job, bytes], tuple[Answer, bytes]]] = MappingProxyType(
    {
        Task.REALIZE: _realized,
        Task.FUNCTIONS: _understood,
        Task.GESTURE_CHECK: authoring.check_gesture,
        Task.GESTURE_MOTION: authoring.play_gesture,
        Task.GESTURE_POSE: authoring.take_pose,
        Task.RULE_CHECK: authoring.check_rules,
        Task.RULE_EXPLANATION: authoring.explain_rule,
        Task.RULE_COMPARISON: authoring.compare_rules,
    }
)


def _headers(notices: Sequence[Notice]) -> dict[str, str]:
    """The codes of all notices, each once."""
    codes = ", ".join(dict.fromkeys(notice.code for notice in notices))
    return {"Vary": "Accept"} | ({WARNINGS_HEADER: codes} if codes else {})
