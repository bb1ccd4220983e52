"""Hears files that commands name: those to be judged, and those that tell how their speaker usually sounds."""

import os
from collections.abc import Sequence
from pathlib import PurePath

from ..errors import InputError
from ..performance import AcousticModels, SignalAnalysis, SpeakerReference, analyze_signal, make_reference
from ..schemas.references import read_reference
from .files import read_bytes
from .log import Log

LARGEST_REFERENCE_BYTES = 1 << 20


def hear_file(
    acoustic: AcousticModels, path: str, log: Log, reference: SpeakerReference | None = None
) -> SignalAnalysis:
    """What the file says; warnings are told. Raises InputError as `hear` does, naming the file of several."""
    name = shown(path)
    audio = read_bytes(path, limit=acoustic.settings.max_audio_bytes, field="audio")
    try:
        heard = analyze_signal(acoustic, audio, reference=reference)
    except InputError as error:
        raise InputError(error.code, f"{name}: {error.message}", field=error.field) from None
    log.warnings(heard.notices, of=name)
    return heard


def speaker_reference(acoustic: AcousticModels, paths: Sequence[str] | None, log: Log) -> SpeakerReference | None:
    """The reference that `--reference` names: recordings, or one .json of `understudy reference`.

    Raises InputError `usage`, `reference_unreadable`, and as `hear_file` does.
    """
    if not paths:
        return None
    stored = [path for path in paths if PurePath(path).suffix.lower() == ".json"]
    if not stored:
        return make_reference(acoustic, [hear_file(acoustic, path, log) for path in paths])
    if len(paths) > 1:
        raise InputError("usage", f"{stored[0]}: --reference takes recordings, or one .json alone", field="reference")
    content = read_bytes(stored[0], limit=LARGEST_REFERENCE_BYTES, field="reference")
    return read_reference(content, shown(stored[0]))


def shown(path: str) -> str:
    """The file's name as text, whatever its bytes."""
    return os.fsencode(path).decode(errors="replace")
