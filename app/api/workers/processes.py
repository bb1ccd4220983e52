"""The service's side of its processes: the nursery, which it starts and commands, the workers that the nursery forks,
and how they look from outside: which are stopped, dead, or too large."""

import os
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Self

import psutil

from ...errors import ServiceError
from ...settings import Settings
from .families import family_of
from .messages import (
    Answer,
    Content,
    Divide,
    Fork,
    Job,
    JobFailure,
    LoadedLibrary,
    Ready,
    Reload,
    Start,
    receive,
    receive_soon,
    send,
    send_soon,
)

COMMAND = (sys.executable, "-m", "understudy.api.workers.nursery")
_ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
"""Matrix products stay on one core: a line is too short to share."""

_DIVIDES_WITHIN_S, _ENDS_WITHIN_S = 10.0, 10.0


@dataclass(frozen=True, slots=True)
class _Origin:
    """The arguments with which a nursery was started."""

    settings: Settings
    logging: dict[str, Any] | None
    command: Sequence[str]


class WorkerLostError(Exception):
    """A worker ended, or its aligner did, before it answered."""


class Nursery:
    """The service's handle of the process that loads everything and forks workers, and of its understudy: a second one,
    forked from it, which takes its place at once when it ends."""

    def __init__(
        self,
        process: "subprocess.Popen[bytes] | psutil.Process",
        control: socket.socket,
        origin: "_Origin",
        library: Mapping[str, bytes] = MappingProxyType({}),
    ) -> None:
        self._process = process
        self._control = control
        self._origin = origin
        self._turn = threading.Lock()
        self._next: Nursery | None = None
        self.library = library

    @classmethod
    def start(
        cls,
        settings: Settings,
        *,
        logging: dict[str, Any] | None = None,
        command: Sequence[str] = COMMAND,
        is_renewal: bool = False,
    ) -> Self:
        """Starts it and waits until everything is loaded.

        Raises AuthoringError with the mistakes in authored files, ServiceError for models, `nursery_ended` when the
        process ended.
        """
        ours, its = socket.socketpair()
        with its:
            process = subprocess.Popen(
                [*command, str(its.fileno())],
                pass_fds=(its.fileno(),),
                env=os.environ | _ONE_THREAD,
                stdin=subprocess.DEVNULL,
                start_new_session=True,
            )
        nursery = cls(process, ours, _Origin(settings, logging, command))
        try:
            send(ours, Start(settings, logging, is_renewal))
            nursery._wait()
        except BaseException:
            nursery.close()
            raise
        return nursery

    @property
    def pid(self) -> int:
        return self._process.pid

    @property
    def next_pid(self) -> int | None:
        """The process id of its understudy, None without one."""
        return self._next.pid if self._next else None

    @property
    def has_ended(self) -> bool:
        """Whether the process has ended."""
        return _is_closed(self._control)

    def divided(self) -> "Nursery":
        """A second nursery, forked from this one with all that it has loaded. Raises EOFError or OSError when this one
        has ended or hangs."""
        library, (ours, its) = self.library, socket.socketpair()
        try:
            with its, self._turn:
                send(self._control, Divide(), pass_on=(its.fileno(),))
            ours.settimeout(_DIVIDES_WITHIN_S)
            ready, _, _ = receive(ours)
            ours.settimeout(None)
            assert isinstance(ready, Ready)
            return Nursery(psutil.Process(ready.pid), ours, self._origin, library)
        except psutil.NoSuchProcess:
            ours.close()
            raise EOFError from None
        except BaseException:
            ours.close()
            raise

    def require_next(self) -> None:
        """Sees to it that there is one to take its place, unless it has ended itself."""
        if self._next is None or self._next.has_ended:
            with suppress(EOFError, OSError):
                following = self.divided()
                if following.library is self.library:
                    self._replace_next(following)
                else:  # files were read again meanwhile
                    following.close()

    def again(self) -> "Nursery":
        """Closes this nursery and returns the one that takes its place, or starts a replacement; raises as `start`
        does."""
        following, self._next = self._next, None
        self.close()
        if following is not None:
            if not following.has_ended:
                return following
            following.close()
        origin = self._origin
        return Nursery.start(origin.settings, logging=origin.logging, command=origin.command, is_renewal=True)

    def fork(self, settings: Settings, *, is_live: bool = False) -> socket.socket:
        """Our end of a new worker's socket, from which `Ready` comes. Raises OSError when the nursery has ended."""
        ours, its = socket.socketpair()
        ours.setblocking(False)
        with its:
            try:
                with self._turn:
                    send(self._control, Fork(settings, is_live), pass_on=(its.fileno(),))
            except OSError:
                ours.close()
                raise
        return ours

    def reload(self) -> None:
        """Reloads all authored files and waits. Raises AuthoringError with their mistakes, in which case nothing
        changes, ServiceError `nursery_ended`."""
        try:
            with self._turn:
                send(self._control, Reload())
        except OSError:
            raise _ended() from None
        self._wait()
        self._replace_next(None)

    def close(self) -> None:
        """Ends the process; workers run until their own sockets are closed."""
        self._replace_next(None)
        self._control.close()
        with suppress(psutil.NoSuchProcess, psutil.TimeoutExpired):
            self._process.kill()
            self._process.wait(_ENDS_WITHIN_S)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()

    def _replace_next(self, following: "Nursery | None") -> None:
        old, self._next = self._next, following
        if old is not None:
            old.close()

    def _wait(self) -> None:
        try:
            message, _, _ = receive(self._control)
        except (EOFError, OSError):
            raise _ended() from None
        if isinstance(message, JobFailure):
            raise message.error
        assert isinstance(message, LoadedLibrary)
        self.library = message.library


@dataclass(slots=True, eq=False)
class Worker:
    """The handle of a worker process. `given_up` is the error of its job if the service killed it for that job; a
    nursery that has just been started forks workers that are not warm."""

    socket: socket.socket
    process: psutil.Process
    shared_bytes: int
    is_warm: bool = True
    began_s: float = field(default_factory=time.monotonic)
    jobs: int = 0
    given_up: ServiceError | Exception | None = None

    @classmethod
    async def forked(cls, nursery: Nursery, settings: Settings, *, is_live: bool = False) -> Self:
        """A new worker, ready for a job, or for a live stream.

        Raises OSError or EOFError when the nursery or the worker ended.
        """
        service = nursery.fork(settings, is_live=is_live)
        try:
            ready, _ = await receive_soon(service)
            assert isinstance(ready, Ready)
            return cls(service, psutil.Process(ready.pid), ready.shared_bytes, ready.is_warm)
        except psutil.NoSuchProcess:
            service.close()
            raise EOFError from None
        except BaseException:
            service.close()
            raise

    async def answer(self, job: Job, content: Content) -> tuple[Answer | JobFailure, bytearray]:
        """The answer to a job; raises WorkerLostError. If this is cancelled, the caller must `end` the worker."""
        self.jobs += 1
        self.given_up = None
        try:
            await send_soon(self.socket, job, content)
            answer, body = await receive_soon(self.socket)
        except (EOFError, OSError):
            if self.given_up is not None:
                raise self.given_up from None
            raise WorkerLostError from None
        assert isinstance(answer, Answer | JobFailure)
        return answer, body

    @property
    def has_ended(self) -> bool:
        """Whether its end of the socket is closed; a killed process may still be listed as a zombie."""
        return _is_closed(self.socket)

    def end(self) -> None:
        """Kills it with its children and closes its socket."""
        self.kill()
        self.socket.close()

    def kill(self) -> None:
        """Kills it with its children; whoever waits for its answer notices the closed socket."""
        with suppress(psutil.NoSuchProcess):
            for each in family_of(self.process):
                with suppress(psutil.NoSuchProcess):
                    each.kill()


def _is_closed(ours: socket.socket) -> bool:
    """Whether the other end of a socket is closed, or this one."""
    try:
        return not ours.recv(1, socket.MSG_PEEK | socket.MSG_DONTWAIT)
    except BlockingIOError:
        return False
    except OSError:
        return True


def wait_until_gone(workers: Sequence[Worker], longest_s: float = 2.0) -> None:
    """Waits until the processes have ended."""
    ends_s = time.monotonic() + longest_s
    while any(worker.process.is_running() for worker in workers) and time.monotonic() < ends_s:
        time.sleep(0.01)


def _ended() -> ServiceError:
    return ServiceError("nursery_ended", "the process that loads the models has ended; the log says why")


@dataclass(frozen=True, slots=True)
class WorkerState:
    """A worker as seen from outside; `trouble` is why it must be replaced, or None."""

    worker: Worker
    trouble: str | None
    is_too_large: bool = False


def look(workers: Sequence[Worker], limit_bytes: int) -> tuple[WorkerState, ...]:
    """The state of each worker with its children. Memory counts beyond what was shared when the worker began."""
    return tuple(_seen(worker, limit_bytes) for worker in workers)


def is_stopped(pid: int) -> bool:
    """Whether a process exists but is stopped (SIGSTOP)."""
    try:
        return psutil.Process(pid).status() == psutil.STATUS_STOPPED
    except psutil.NoSuchProcess:
        return False


def _seen(worker: Worker, limit_bytes: int) -> WorkerState:
    pid = worker.process.pid
    try:
        family = family_of(worker.process)
        stopped = [each.pid for each in family if each.status() == psutil.STATUS_STOPPED]
        grown_bytes = sum(each.memory_info().rss for each in family) - worker.shared_bytes
    except psutil.NoSuchProcess:
        if worker.process.is_running():
            return WorkerState(worker, None)  # a process of its own ended as it was looked at
        return WorkerState(worker, f"worker {pid} has ended and is being replaced")
    if stopped:
        whose = "it" if pid in stopped else "its aligner"
        return WorkerState(worker, f"worker {pid} is being replaced: {whose} was stopped")
    if grown_bytes > limit_bytes:
        return WorkerState(worker, f"worker {pid} is being replaced: it took too much memory", is_too_large=True)
    return WorkerState(worker, None)
