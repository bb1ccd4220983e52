"""Writes the log of the command line to standard error, in one of three voices: for people, for machines, or errors
only.

`--json-log` gives one JSON object a line, `--quiet` errors alone. Results are never written here.
"""

from __future__ import annotations

import json
import logging
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Any

from ..errors import InputError, UnderstudyError

if TYPE_CHECKING:
    from ..model import Notice


class Audience(StrEnum):
    """For whom the log is written."""

    PEOPLE = "people"
    MACHINES = "machines"
    QUIET = "quiet"


@dataclass(frozen=True, slots=True)
class Log:
    """Writes events to standard error."""

    voice: Audience

    @classmethod
    def for_arguments(cls, argv: Sequence[str]) -> Log:
        """The voice that `argv` asks for, wherever the option is: mistakes in `argv` itself are reported in it too."""
        if "--json-log" in argv:
            return cls(Audience.MACHINES)
        return cls(Audience.QUIET if "--quiet" in argv else Audience.PEOPLE)

    def stage(self, name: str) -> None:
        """Reports that a stage of a performance begins."""
        if self.voice is Audience.MACHINES:
            _write(json.dumps({"event": "stage", "stage": name}))

    def warnings(self, notices: Sequence[Notice], *, of: str = "") -> None:
        """Reports what was degraded, dropped or guessed; `of` is the file it concerns if there are several."""
        for notice in notices:
            self._say("warning", f"warning: {of + ': ' if of else ''}{notice.message}", code=notice.code)

    def note(self, message: str) -> None:
        """Reports something a person may want to know."""
        self._say("note", message)

    def problem(self, message: str) -> None:
        """Reports a problem with a part of the input that does not stop the rest."""
        self._say("problem", message)

    def event(self, name: str, fields: Mapping[str, object], message: str) -> None:
        """Reports a step of long work: all fields for machines, `message` for people, if there is one."""
        if self.voice is Audience.MACHINES:
            _write(json.dumps({"event": name, **fields}))
        elif message:
            self._say(name, message)

    def progress(self, message: str) -> None:
        """Reports the progress of long work to people; machines have its events."""
        if self.voice is Audience.PEOPLE:
            _write(message)

    def error(self, error: UnderstudyError) -> None:
        """Reports the error that ended the command: on one line, or one line a mistake, with its source line in
        authored files."""
        if self.voice is Audience.MACHINES:
            field = error.field if isinstance(error, InputError) else None
            _write(json.dumps({"event": "error", "code": error.code, "field": field, "message": error.message}))
        elif error.names_places:
            _write(error.message)
        else:
            _write(f"understudy: {' '.join(error.message.splitlines())}")

    def service_logging(self) -> dict[str, Any]:
        """The logging configuration of the service in this voice, for `logging.config.dictConfig`."""
        form = (
            {"()": JsonLines}
            if self.voice is Audience.MACHINES
            else {"format": "%(levelname)s: %(message)s%(request)s"}
        )
        return {
            "version": 1,
            "disable_existing_loggers": False,
            "formatters": {"line": form},
            "filters": {"request": {"()": "understudy.api.admission.headers.WithRequestId"}},
            "handlers": {"stderr": {"class": "logging.StreamHandler", "formatter": "line", "filters": ["request"]}},
            "loggers": {"uvicorn.access": {"level": "WARNING"}},
            "root": {"handlers": ["stderr"], "level": "ERROR" if self.voice is Audience.QUIET else "INFO"},
        }

    def _say(self, event: str, message: str, **fields: str) -> None:
        if self.voice is Audience.MACHINES:
            _write(json.dumps({"event": event, **fields, "message": message}))
        elif self.voice is Audience.PEOPLE:
            _write(message)


class JsonLines(logging.Formatter):
    """The service's log as one JSON object a line."""

    def format(self, record: logging.LogRecord) -> str:
        event = {"event": "log", "level": record.levelname.lower(), "message": record.getMessage()}
        event |= getattr(record, "fields", {})
        if request_id := getattr(record, "request_id", ""):
            event["request_id"] = request_id
        if record.exc_info:
            event["traceback"] = self.formatException(record.exc_info)
        return json.dumps(event)


def _write(line: str) -> None:
    sys.stderr.write(line + "\n")
    sys.stderr.flush()
