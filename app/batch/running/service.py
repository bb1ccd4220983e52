"""Another Understudy's service as an engine: posts lines to `/perform`, and waits while the service is full.

It supports the schedule and the whole performance, not motion and the other formats of a local worker. A gesture
profile in a local file is sent, rounded as in `profiles.files.writing`. Listeners are played by the character of their
own name only. Voices are learnt on this machine.
"""

import json
import threading
import time
from collections.abc import Iterator, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import replace
from email.utils import parsedate_to_datetime
from typing import Any

import requests

from ...errors import InputError, ServiceError
from ...model import EMPHASISED, Notice
from ...model.edits import NO_EDITS
from ...model.formats import DialectName
from ...model.voice.signal import SpeakerReference
from ...profiles.files.writing import profile_yaml
from ...profiles.profile import Profile
from ...schemas.affect import affect_rows
from ...schemas.direction import direction_fields
from ...schemas.edits import write_edits
from ...schemas.references import ReferenceForm
from ...settings import PREFIX, Settings
from ..work.formats import LineFormat, OutputFormat, act_path, beside, extension_of, recording_name
from ..work.jobs import Failure, LineJob, LineOutcome, Measures, OutputFile, OutputTarget, ReferenceJob
from ..work.worker import learn_in_worker
from .local import Processes

SERVED = frozenset({LineFormat.BML, LineFormat.PERFORMANCE, LineFormat.WAV})

ANSWER_S = 300.0
"""Timeout of a response."""

LONGEST_WAIT_S = 600.0
"""How long a line is retried while the service is full or unreachable."""

USUAL_WAIT_S, MOST_WAIT_S = 1.0, 60.0


class ServiceEngine:
    """A service at a URL, to which `posts` lines are posted at a time."""

    def __init__(self, url: str, posts: int, settings: Settings) -> None:
        """Raises InputError `service_unreachable`, and `key_wrong` where the API key is missing or not accepted."""
        self.places = posts
        self._url = url.rstrip("/")
        self._settings = settings
        self._threads = ThreadPoolExecutor(posts, thread_name_prefix="post")
        self._voices = Processes(1)
        self._closed = threading.Event()
        self._headers = _headers(settings)
        _require_ready(self._url, self._headers)

    def submit(self, job: LineJob) -> "Future[LineOutcome]":
        return self._threads.submit(self._perform, job)

    def learn(self, job: ReferenceJob) -> "Future[SpeakerReference | None]":
        return self._voices.call(learn_in_worker, job, self._settings)

    def close(self) -> None:
        self._closed.set()
        self._voices.close()
        self._threads.shutdown(cancel_futures=True)

    def _perform(self, job: LineJob) -> LineOutcome:
        start_s = time.perf_counter()
        try:
            audio = job.audio.content()
        except InputError as error:
            return LineOutcome(job.id, time.perf_counter() - start_s, failure=Failure.of(error))
        answer = self._posted(job, audio)
        seconds = time.perf_counter() - start_s
        if answer.ok:
            told = answer.json()
            notices = tuple(Notice(each["code"], each["message"]) for each in told["warnings"])
            return LineOutcome(
                job.id, seconds, tuple(_files(job, audio, told)), notices, _measures(told["performance"])
            )
        failure = _failure(answer)
        if answer.status_code >= requests.codes.internal_server_error:
            raise ServiceError(failure.code, failure.message)
        return LineOutcome(job.id, seconds, failure=failure)

    def _posted(self, job: LineJob, audio: bytes) -> requests.Response:
        """The response. While the service is full or unreachable, the line is posted again after the time in
        `Retry-After`, or with growing intervals.

        Raises ServiceError `service_unreachable` when that takes too long.
        """
        ends_s = time.monotonic() + LONGEST_WAIT_S
        wait_s = USUAL_WAIT_S
        while True:
            answer, trouble = _post(f"{self._url}/perform", job, audio, self._headers)
            if answer is not None and answer.status_code not in {429, 503}:
                return answer
            told_s = _told_wait_s(answer) if answer is not None else None
            if time.monotonic() > ends_s or self._closed.wait(wait_s if told_s is None else told_s):
                raise ServiceError("service_unreachable", f"{self._url}: {trouble or 'full'} for {LONGEST_WAIT_S:g} s")
            wait_s = min(2 * wait_s, MOST_WAIT_S)


def require_served(formats: tuple[OutputFormat, ...]) -> None:
    """Raises InputError `format_unknown` for formats that the service does not write."""
    others = [extension_of(form) for form in formats if form not in SERVED]
    if others:
        known = ", ".join(sorted(extension_of(form) for form in SERVED))
        message = f"--format {others[0]}: over --service there are {known}; leave --service out for the others"
        raise InputError("format_unknown", message, field="format")


def _headers(settings: Settings) -> dict[str, str]:
    key = settings.api_key
    return {"Accept": "application/json"} | ({"Authorization": f"Bearer {key.get_secret_value()}"} if key else {})


def _require_ready(url: str, headers: Mapping[str, str]) -> None:
    try:
        answer = requests.get(f"{url}/characters", headers=headers, timeout=ANSWER_S)
        if answer.status_code == requests.codes.unauthorized:
            message = f"{url}: {_failure(answer).message}; batch sends what is in {PREFIX}API_KEY"
            raise InputError("key_wrong", message, field="service")
        answer.raise_for_status()
    except requests.RequestException as error:
        message = f"{url}: no service answers there ({type(error).__name__}); start one with understudy serve"
        raise InputError("service_unreachable", message, field="service") from None


def _post(url: str, job: LineJob, audio: bytes, headers: Mapping[str, str]) -> tuple[requests.Response | None, str]:
    """The response, or why there is none."""
    files = {"audio": (_audio_name(job), audio)}
    if isinstance(job.options.profile, Profile):
        files["profile"] = (f"{job.options.profile.name}.yaml", profile_yaml(job.options.profile))
    fields = {"text": job.text, "options": json.dumps(_options(job))}
    if job.direction is not None:
        fields["direction"] = json.dumps(direction_fields(job.direction))
    if job.options.edits != NO_EDITS:
        fields["edits"] = write_edits(job.options.edits).decode()
    try:
        return requests.post(url, data=fields, files=files, headers=headers, timeout=ANSWER_S), ""
    except requests.RequestException as error:
        return None, type(error).__name__


def _audio_name(job: LineJob) -> str:
    """The recording's own name, or for SmartBody its name beside the BML file."""
    written = [target.path for target in job.targets if target.form is LineFormat.BML]
    is_renamed = written and job.options.form.dialect is DialectName.SMARTBODY
    return recording_name(written[0]) if is_renamed else job.audio.path.name


def _options(job: LineJob) -> dict[str, Any]:
    """The options under their names in the service's requests."""
    options = job.options
    fields: dict[str, Any] = {
        "character": options.character,
        "seed": options.seed,
        "mode": options.mode.value,
        "listener": list(options.listeners),
        "dialect": options.form.dialect.value,
        "timing": options.form.timing.value,
        "visemes": options.form.visemes.value,
        "bmlt_audio": options.form.bmlt_audio,
        "lead_in_s": options.lead_in_s,
        "stillness": options.stillness,
        "targets": {target.name: target.position_m for target in options.targets},
    }
    if options.choice is not None:
        fields["choice"] = options.choice
    if options.agitation is not None:
        fields["agitation"] = options.agitation.value
    if options.affect is not None:
        fields["affect"] = affect_rows(options.affect)
    if isinstance(options.profile, str):
        fields["profile"] = options.profile
    if options.reference is not None:
        fields["reference"] = ReferenceForm.of(options.reference).model_dump()
    return fields


def _told_wait_s(answer: requests.Response) -> float | None:
    """`Retry-After`, in seconds or as a date; None if it is missing or unreadable."""
    value = answer.headers.get("Retry-After", "")
    if value.isdecimal():
        return min(float(value), MOST_WAIT_S)
    try:
        return min(max(parsedate_to_datetime(value).timestamp() - time.time(), 0.0), MOST_WAIT_S)
    except ValueError:
        return None


def _failure(answer: requests.Response) -> Failure:
    """The failure in the service's problem response (RFC 9457)."""
    try:
        problem = answer.json()
        return Failure(problem["code"], problem["detail"])
    except (ValueError, KeyError, TypeError):
        return Failure("service_failed", f"the service answered {answer.status_code} {answer.reason}")


def _files(job: LineJob, audio: bytes, answer: Mapping[str, Any]) -> Iterator[OutputFile]:
    for target in job.targets:
        match target.form:
            case LineFormat.PERFORMANCE:
                content = json.dumps(answer["performance"], indent=2, ensure_ascii=False).encode() + b"\n"
            case LineFormat.WAV:
                content = audio
            case _:
                yield from _bml_files(target, answer)
                continue
        yield _file(target, content)


def _bml_files(target: OutputTarget, answer: Mapping[str, Any]) -> Iterator[OutputFile]:
    """The same files as `understudy.batch.work.performing` writes."""
    if answer.get("speech_file"):
        yield _file(target, answer["speech_file"]["bml"].encode())
        target = replace(target, path=act_path(target.path))
    yield _file(target, answer["bml"].encode())
    for name, block in (answer.get("listeners") or {}).items():
        yield _file(replace(target, path=beside(target.path, name, target.form)), block.encode(), name)


def _file(target: OutputTarget, content: bytes, listener: str = "") -> OutputFile:
    return OutputFile(target.form, target.path, len(content), listener, content)


def _measures(answer: Mapping[str, Any]) -> Measures:
    """The measures in the performance, which does not include pitch."""
    kept = [behavior for behavior in answer["behaviors"] if behavior["kept"]]
    gestures = [behavior for behavior in answer["behaviors"] if behavior["kind"] == "gesture"]
    functions: dict[str, int] = {}
    for function in answer["functions"]:
        if function["kept"]:
            functions[function["class"]] = functions.get(function["class"], 0) + 1
    return Measures(
        duration_s=round(answer["audio"]["duration_s"], 3),
        words=len(answer["words"]),
        agitation=answer["agitation"] or "",
        functions=dict(sorted(functions.items())),
        gestures=sum(gesture["kept"] for gesture in gestures),
        gestures_dropped=sum(not gesture["kept"] for gesture in gestures),
        behaviors=len(kept),
        emphasised=sum((word.get("emphasis") or 0.0) > EMPHASISED for word in answer["words"]),
        pitch_spread_st=None,
    )
