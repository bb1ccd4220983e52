"""Hears files that commands name: those to be judged, and those that tell how their speaker usually sounds."""

import os
from collections.abc import Sequence
from pathlib import PurePath

from app.cli.files import read_bytes
from app.cli.log import Log
from app.errors import InputError
from app.performance import Ears, Heard, SpeakerReference, hear, refer
from app.references import read_reference

LARGEST_REFERENCE_BYTES = 1 << 20


def hear_file(ears: Ears, path: str, log: Log, reference: SpeakerReference | None = None) -> Heard:
    """What the file says; warnings are told. Raises InputError as `hear` does, naming the file of several."""
    name = shown(path)
    audio = read_bytes(path, limit=ears.settings.max_audio_bytes, field="audio")
    try:
        heard = hear(ears, audio, reference=reference)
    except InputError as error:
        raise InputError(error.code, f"{name}: {error.message}", field=error.field) from None
    log.warnings(heard.notices, of=name)
    return heard


def speaker_reference(ears: Ears, paths: Sequence[str] | None, log: Log) -> SpeakerReference | None:
    """The reference that `--reference` names: recordings, or one .json of `understudy reference`.

    Raises InputError `usage`, `reference_unreadable`, and as `hear_file` does.
    """
    if not paths:
        return None
    stored = [path for path in paths if PurePath(path).suffix.lower() == ".json"]
    if not stored:
        return refer(ears, [hear_file(ears, path, log) for path in paths])
    if len(paths) > 1:
        raise InputError("usage", f"{stored[0]}: --reference takes recordings, or one .json alone", field="reference")
    content = read_bytes(stored[0], limit=LARGEST_REFERENCE_BYTES, field="reference")
    return read_reference(content, shown(stored[0]))


def shown(path: str) -> str:
    """The file's name as text, whatever its bytes."""
    return os.fsencode(path).decode(errors="replace")
