"""The process that loads everything once and forks the workers, which share its memory until they write to it.

It has one thread, so that forking is safe. Run as `python -m understudy.api.workers.nursery DESCRIPTOR`, it obeys the
messages on that socket and ends when it closes. Requires Unix.
"""

import gc
import logging.config
import os
import select
import signal
import socket
import sys
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Never

import numpy as np
import psutil
from pydantic import BaseModel

from ...authoring.catalogue import Catalogue, ItemKind
from ...authoring.inspection import read_again
from ...errors import UnderstudyError
from ...files import resource_folder
from ...library.hearing import read_audio
from ...library.motion import realize
from ...library.performing import perform_line
from ...live.messages import LiveOptions
from ...live.models import LiveModels
from ...live.session import LiveSession
from ...model import SAMPLE_RATE_HZ, Line
from ...models import Understudy
from ...options import Options
from ...schemas.gestures.language import GestureLanguageResponse
from ...schemas.library import CharactersResponse, GesturesResponse, RulesResponse
from .live_worker import stream
from .messages import Divide, Fork, JobFailure, LoadedLibrary, Ready, Reload, Start, receive, send
from .worker import work

LISTENED_S = 3.0
"""How much of the bundled line is streamed: a phrase, and whatever is loaded lazily is loaded."""

STEPS = 20
"""The chunks of each half of it, .075 s each."""

IDLE_S = 1.0
"""A nursery that replaces one that died forks at once, since jobs and streams are waiting, and warms up after it has
been idle for this long. Its first workers do their own lazy loading, and are replaced when there is time."""


def main(control: socket.socket) -> None:
    """Loads everything, then forks and reloads on request, until the socket closes."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    start, _, _ = receive(control)
    assert isinstance(start, Start)
    if start.logging is not None:
        logging.config.dictConfig(start.logging)
    try:
        understudy = Understudy.load(start.settings)
        models = LiveModels.load(understudy)
        if not start.is_renewal:
            _warm(models)
    except UnderstudyError as error:
        send(control, JobFailure(error))
        return
    with suppress(BrokenPipeError):  # the service has ended meanwhile, which the next receive notices
        send(control, LoadedLibrary(_library(understudy)))
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # ended workers are reaped by the kernel
    with suppress(EOFError), tempfile.TemporaryFile() as turns:  # the service has closed its end
        nursery = _Forking(control, models, turns.fileno(), is_warm=not start.is_renewal)
        if start.is_renewal:
            nursery.obey(idle_s=IDLE_S)
            _warm(nursery.models)
            nursery.is_warm = True
        nursery.obey()
    os._exit(0)  # a forked process's interpreter would wait at its end for threads that it does not have


@dataclass(slots=True)
class _Forking:
    """What a nursery does once all is loaded. `turns` is the file by which streams take turns; it `is_warm` when it has
    done everything once."""

    control: socket.socket
    models: LiveModels
    turns: int
    is_warm: bool

    def obey(self, idle_s: float | None = None) -> None:
        """Forks and reloads on request; returns after `idle_s` without a request. Raises EOFError when the socket
        closes."""
        while select.select([self.control], [], [], idle_s)[0]:
            message, _, descriptors = receive(self.control)
            match message:
                case Reload():
                    self.models = _reloaded(self.control, self.models)
                case Fork():
                    self._fork(message, socket.socket(fileno=descriptors[0]))
                case Divide():
                    self._divide(socket.socket(fileno=descriptors[0]))

    def _fork(self, fork: Fork, service: socket.socket) -> None:
        with service:
            if os.fork() == 0:
                self.control.close()
                self._be_worker(service, fork)

    def _be_worker(self, service: socket.socket, fork: Fork) -> Never:
        """Runs the worker and exits; the nursery's code never continues in a worker."""
        understudy = self.models.understudy.with_settings(fork.settings)
        try:
            signal.signal(signal.SIGCHLD, signal.SIG_DFL)
            if fork.is_live:
                stream(service, replace(self.models, understudy=understudy), fork.settings, self.turns)
            else:
                work(service, understudy, is_warm=self.is_warm)
        finally:
            os._exit(0)

    def _divide(self, control: socket.socket) -> None:
        """Both processes go on in the same place; the new one obeys the new socket, and rests until it is needed."""
        if os.fork():
            control.close()
            return
        self.control.close()
        self.control = control
        with suppress(BrokenPipeError):
            send(control, Ready(os.getpid(), psutil.Process().memory_info().rss))
        select.select([control], [], [])


def _warm(models: LiveModels) -> None:
    """Performs and realizes the bundled line, streams its beginning live and builds all schemas, so that workers
    inherit what is loaded lazily; then freezes all objects, since garbage collection would write to shared pages."""
    import scipy.optimize  # noqa: F401  # for profiles, which this line does without

    examples = resource_folder("examples")
    sound, text = (examples / "example.flac").read_bytes(), (examples / "example.txt").read_text(encoding="utf-8")
    performed = perform_line(models.understudy, Line(sound, text), Options())
    realize(models.understudy, performed.performance, fps=30)
    _listen_to(models, sound, text)
    models.understudy.close()
    _build_schemas(BaseModel)
    gc.collect()
    gc.freeze()


def _build_schemas(base: type[BaseModel]) -> None:
    """Builds the pydantic schemas of our classes with that base, which otherwise are built on first use."""
    for schema in base.__subclasses__():
        if schema.__module__.startswith("understudy."):
            schema.model_rebuild()
        _build_schemas(schema)


def _listen_to(models: LiveModels, sound: bytes, text: str) -> None:
    """The first half by the voice alone, the second with its words."""
    samples = read_audio(sound, models.understudy.acoustic.settings)[0].samples[: round(LISTENED_S * SAMPLE_RATE_HZ)]
    session = LiveSession(models, LiveOptions(frame_rate_hz=30))
    for half in np.array_split(samples, 2):
        for part in np.array_split(half, STEPS):
            session.hear(part)
        session.text(text)


def _reloaded(control: socket.socket, models: LiveModels) -> LiveModels:
    """The newly loaded models, or the old ones if the files have mistakes."""
    try:
        again = LiveModels.load(read_again(models.understudy))
    except UnderstudyError as error:
        send(control, JobFailure(error))
        return models
    send(control, LoadedLibrary(_library(again.understudy)))
    return again


def _library(understudy: Understudy) -> Mapping[str, bytes]:
    """The answers of the service about characters, gestures, rules and words, as JSON by path."""
    behavior = understudy.behavior
    catalogue = Catalogue.of(understudy.language.rules, behavior.characters, behavior.rules, behavior.families)
    words, rules = (
        RulesResponse.of(item for item in catalogue.items if (item.kind is ItemKind.WORD) is are_words)
        for are_words in (True, False)
    )
    return {
        "/characters": CharactersResponse.of(catalogue.characters.by_name.values()).to_json(),
        "/gestures": GesturesResponse.of(
            understudy.realizer.library.definitions, behavior.families, behavior.characters
        ).to_json(),
        "/rules": rules.to_json(),
        "/lexicon": words.to_json(),
        "/gestures/language": GestureLanguageResponse.of(understudy.realizer.skeleton).to_json(),
    }


if __name__ == "__main__":
    main(socket.socket(fileno=int(sys.argv[1])))
