"""The id of a request: the client's if it is a sane one, otherwise a new one; on the answer and in the log."""

import logging
import re
from contextvars import ContextVar
from uuid import uuid4

HEADER = "x-request-id"

_SANE = re.compile(r"[A-Za-z0-9._-]{1,64}", re.ASCII)

current_id: ContextVar[str] = ContextVar("current_id", default="")
"""That of the request which this task answers."""


def request_id(sent: str | None) -> str:
    """The id for a request whose header says `sent`."""
    return sent if sent is not None and _SANE.fullmatch(sent) else uuid4().hex


class WithRequestId(logging.Filter):
    """Gives records the attribute `request_id`, and `request` to end a line with."""

    def filter(self, record: logging.LogRecord) -> bool:
        found = current_id.get()
        record.__dict__ |= {"request_id": found, "request": f" [{found}]" if found else ""}
        return True
