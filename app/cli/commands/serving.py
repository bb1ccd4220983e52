"""Runs the service until it is stopped: `understudy serve`; and `understudy studio`, for this machine alone, with the
studio's page opened in the browser, with a line or a scene if one is given."""

import argparse
import webbrowser
from pathlib import Path

from ...authored_folders import layers
from ...errors import InputError
from ...settings import Settings, read_settings
from ...studio.pages import OpenedLine
from ...studio.scenes import OpenedScene
from ...text.transcript import MAX_CHARACTERS
from ..files import STANDARD, read_bytes, read_text
from ..log import Log
from ..service import run_service

LOOPBACK = "127.0.0.1"


def serve(arguments: argparse.Namespace, log: Log) -> int:
    """Raises KeyboardInterrupt, after everything has ended, if that is what stopped it."""
    settings = read_settings()
    origins = ", ".join(arguments.allow_origin) if arguments.allow_origin else None
    chosen = {"host": arguments.host, "port": arguments.port, "allowed_origins": origins}
    settings = settings.model_copy(update={key: value for key, value in chosen.items() if value is not None})
    return run_service(settings, log, reload=arguments.reload)


def studio(arguments: argparse.Namespace, log: Log) -> int:
    """Raises KeyboardInterrupt, after everything has ended, if that is what stopped it; InputError for what cannot be
    read."""
    settings = read_settings().model_copy(update={"host": LOOPBACK, "port": arguments.port, "studio": True})
    if arguments.allow_origin:
        settings = settings.model_copy(update={"allowed_origins": ", ".join(arguments.allow_origin)})
    scene = _scene(arguments)
    line = _line(arguments, settings)
    asked = "scene=opened" if scene else "line=opened" if line else "line=example"

    def show(address: str) -> None:
        page = f"{address}/?{asked}"
        log.note(f"the studio is at {page}")
        if not arguments.no_browser:
            webbrowser.open(page)

    folder = _rules_folder(arguments)
    return run_service(
        settings, log, reload=arguments.reload, opened=scene or line, author_folder=folder, when_started=show
    )


def _rules_folder(arguments: argparse.Namespace) -> Path | None:
    """The folder where rules may be saved, the author's lexicon if no other is named; raises InputError
    `file_unwritable` if it does not exist."""
    told = arguments.rules or next(reversed(layers()), None)
    if told is None:
        return None
    folder = Path(told)
    if not folder.is_dir():
        raise InputError("file_unwritable", f"{folder}: no such folder; rules are saved in one", field="rules")
    return folder


def _scene(arguments: argparse.Namespace) -> OpenedScene | None:
    """The scene to open; raises InputError `usage` if a line is given as well."""
    if arguments.scene is None:
        return None
    if arguments.audio is not None:
        raise InputError("usage", "a line and a scene were given; open one of them")
    return OpenedScene.of(Path(arguments.scene))


def _line(arguments: argparse.Namespace, settings: Settings) -> OpenedLine | None:
    """The line to open; raises InputError `usage` for words without a recording."""
    if arguments.audio is None:
        if arguments.text is not None or arguments.text_file is not None:
            raise InputError("usage", "words were given without their recording; give AUDIO, too")
        return None
    audio = read_bytes(arguments.audio, limit=settings.max_audio_bytes, field="audio")
    name = "line.wav" if arguments.audio == STANDARD else Path(arguments.audio).name
    return OpenedLine(audio, name, _text(arguments))


def _text(arguments: argparse.Namespace) -> str:
    """The words; empty if none are given, in which case the page asks for them."""
    if arguments.text_file is None:
        return arguments.text or ""
    return read_text(arguments.text_file, max_characters=MAX_CHARACTERS, field="text").strip()
