"""The main loop of a worker: jobs come in over its socket, one at a time, and answers go back, until the socket closes.

When the socket closes, even because the service has died, the worker ends at once with its aligner. The kernel refuses
memory beyond its limit, which is answered as an error.
"""

import logging
import os
import socket

import psutil

from ...errors import ServiceError, UnderstudyError
from ...models import Understudy
from .answering import answered
from .families import end, end_with
from .known_lines import KnownLines
from .limits import limit_memory, too_large
from .messages import Answer, Job, JobFailure, Ready, receive, send

_LOGGER = logging.getLogger(__name__)


def work(service: socket.socket, understudy: Understudy, *, is_warm: bool) -> None:
    """Answers jobs until there are no more."""
    end_with(service)
    settings = understudy.acoustic.settings
    limit_memory(settings.worker_memory_bytes)
    understudy.acoustic.aligner.warm_up()
    send(service, Ready(os.getpid(), psutil.Process().memory_info().rss, is_warm))
    known = KnownLines()
    while True:
        try:
            job, content, _ = receive(service)
            assert isinstance(job, Job)
            answer, body = _answer(understudy, job, bytes(content), known)
            del content
            send(service, answer, body)
        except (EOFError, OSError):
            break
    end()


def _answer(understudy: Understudy, job: Job, content: bytes, known: KnownLines) -> tuple[Answer | JobFailure, bytes]:
    try:
        return answered(understudy, job, content, known)
    except UnderstudyError as error:
        return JobFailure(error), b""
    except MemoryError:
        return JobFailure(too_large(understudy.acoustic.settings.worker_memory_bytes)), b""
    except Exception:
        _LOGGER.exception("internal error in a request to %s", job.task)
        return JobFailure(ServiceError("internal_error", "see the log")), b""
