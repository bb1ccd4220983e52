"""Performs by a service over HTTP (`understudy serve`)."""

import json
import time
from dataclasses import dataclass
from typing import Any
from urllib.parse import urlsplit

import requests

from ..motion.clip import Clip, read_clip
from .requests import Cancellation, CancelledError, Line, Performed, PerformingError, Progress, Remark, Sheet
from .still import still_bml

LONGEST_WAIT_S = 300.0
MOST_TRIES = 4
LONGEST_PAUSE_S = 10.0


def is_local(url: str) -> bool:
    """Whether a service is on this machine, so that no network is needed."""
    return (urlsplit(url).hostname or "") in {"localhost", "127.0.0.1", "::1"}


@dataclass(frozen=True, slots=True)
class Service:
    """The service at a URL, with the key that it asks for, if any."""

    url: str
    key: str = ""

    def perform(self, line: Line, progress: Progress, cancelled: Cancellation) -> Performed:
        """A line to BML."""
        progress("perform")
        form: dict[str, Any] = {
            "text": (None, line.text),
            "options": (None, json.dumps(line.options)),
            "audio": (line.audio.name, line.audio.read_bytes()),
        }
        if line.edits is not None:
            form["edits"] = (None, json.dumps(line.edits))
        answer = self._posted("/perform", form, "application/json", cancelled).json()
        listeners = {name: bml.encode() for name, bml in answer.get("listeners", {}).items()}
        warnings = tuple(Remark(each["code"], each["message"]) for each in answer.get("warnings", []))
        return Performed(answer["bml"].encode(), answer["performance"], warnings, listeners)

    def realize(self, sheet: Sheet, progress: Progress, cancelled: Cancellation) -> Clip:
        """BML to motion."""
        progress("realize")
        return read_clip(self._realized(sheet, "application/json", cancelled))

    def mannequin(self, character: str) -> bytes:
        """A character's own body as GLB."""
        return self._realized(Sheet(still_bml(character)), "model/gltf-binary", lambda: False)

    def _realized(self, sheet: Sheet, accept: str, cancelled: Cancellation) -> bytes:
        form: dict[str, Any] = {
            "bml": ("line.bml", sheet.bml),
            "options": (None, json.dumps(sheet.options)),
        }
        if sheet.audio is not None:
            form["audio"] = (sheet.audio.name, sheet.audio.read_bytes())
        return self._posted("/realize", form, accept, cancelled).content

    def _posted(self, path: str, form: dict[str, Any], accept: str, cancelled: Cancellation) -> requests.Response:
        """The answer, once a full service has room. Raises PerformingError with what the service says is wrong."""
        headers = {"Accept": accept} | ({"Authorization": f"Bearer {self.key}"} if self.key else {})
        for _try in range(MOST_TRIES):
            answer = self._sent(path, form, headers)
            if cancelled():
                raise CancelledError
            if answer.status_code not in {429, 503}:
                break
            time.sleep(min(_seconds(answer.headers.get("Retry-After", "1")), LONGEST_PAUSE_S))
        if not answer.ok:
            raise PerformingError(_problem(answer))
        return answer

    def _sent(self, path: str, form: dict[str, Any], headers: dict[str, str]) -> requests.Response:
        try:
            return requests.post(self.url.rstrip("/") + path, files=form, headers=headers, timeout=LONGEST_WAIT_S)
        except requests.Timeout:
            raise PerformingError(f"the service at {self.url} did not answer within {LONGEST_WAIT_S:.0f} s") from None
        except (requests.RequestException, ValueError):
            message = (
                f"no service answers at {self.url}: start it (understudy serve), or change the add-on's preferences"
            )
            raise PerformingError(message) from None


def _problem(answer: requests.Response) -> str:
    """What the service says is wrong (RFC 9457), else its status."""
    try:
        problem = answer.json()
        return str(problem.get("detail") or problem["title"])
    except (ValueError, KeyError, AttributeError):
        return f"the service answered {answer.status_code} {answer.reason}"


def _seconds(text: str) -> float:
    return float(text) if text.isdecimal() else 1.0
