"""Analyses recordings named on the command line: those to be judged, and those of a speaker's usual voice."""

import os
from collections.abc import Sequence
from pathlib import PurePath

from ...errors import InputError
from ...library.hearing import AcousticModels, analyze_signal, make_reference
from ...model import SignalAnalysis
from ...model.voice.signal import SpeakerReference
from ...schemas.references import read_reference
from ...settings import Settings
from ..files import STANDARD, read_bytes
from ..log import Log

LARGEST_REFERENCE_BYTES = 1 << 20


def hear_file(
    acoustic: AcousticModels, path: str, log: Log, reference: SpeakerReference | None = None
) -> SignalAnalysis:
    """The analysis of a file; warnings are logged. Raises InputError as `analyze_signal` does, with the file's name."""
    name = shown(path)
    audio = read_bytes(path, limit=acoustic.settings.max_audio_bytes, field="audio")
    try:
        heard = analyze_signal(acoustic, audio, reference=reference)
    except InputError as error:
        raise InputError(error.code, f"{name}: {error.message}", field=error.field) from None
    log.warnings(heard.notices, of=name)
    return heard


def require_reference(paths: Sequence[str] | None, settings: Settings) -> None:
    """Raises InputError as `speaker_reference` does for files that are missing, too large, or not a reference."""
    if paths and _stored(paths) is None:
        require_files(paths, settings)


def require_files(paths: Sequence[str], settings: Settings) -> None:
    """Raises InputError `file_unreadable`, TooLargeError `file_too_large` for the first recording that cannot be read;
    standard input is only read later."""
    for path in paths:
        if path != STANDARD:
            read_bytes(path, limit=settings.max_audio_bytes, field="audio")


def speaker_reference(acoustic: AcousticModels, paths: Sequence[str] | None, log: Log) -> SpeakerReference | None:
    """The reference that `--reference` names: recordings, or one .json of `understudy reference`.

    Raises InputError `usage`, `reference_unreadable`, and as `hear_file` does.
    """
    if not paths:
        return None
    return _stored(paths) or make_reference(acoustic, [hear_file(acoustic, path, log) for path in paths])


def _stored(paths: Sequence[str]) -> SpeakerReference | None:
    """The reference in the one .json among the paths; None when there is none."""
    stored = [path for path in paths if PurePath(path).suffix.lower() == ".json"]
    if not stored:
        return None
    if len(paths) > 1:
        raise InputError("usage", f"{stored[0]}: --reference takes recordings, or one .json alone", field="reference")
    content = read_bytes(stored[0], limit=LARGEST_REFERENCE_BYTES, field="reference")
    return read_reference(content, shown(stored[0]))


def shown(path: str) -> str:
    """The file's name as text, even if it is not valid UTF-8."""
    return os.fsencode(path).decode(errors="replace")
