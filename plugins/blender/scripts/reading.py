"""Reads a script by the ending of its file, and finds the recordings of its lines."""

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from .model import ScriptError, ScriptLine
from .screenplays import read_screenplay
from .sheets import read_sheet
from .subtitles import read_subtitles

_READERS: Mapping[str, Callable[[str, str], tuple[ScriptLine, ...]]] = {
    ".csv": read_sheet,
    ".tsv": read_sheet,
    ".srt": read_subtitles,
    ".fountain": read_screenplay,
}
ENDINGS = tuple(_READERS)
_SOUNDS = (".wav", ".flac", ".ogg", ".mp3", ".m4a", ".aac", ".opus", ".aif", ".aiff")


def read_script(path: Path) -> tuple[ScriptLine, ...]:
    """The lines of a script. Raises ScriptError and OSError."""
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        raise ScriptError(f"{path.name}: a script is {', '.join(ENDINGS)}")
    try:
        return reader(_text(path.read_bytes()), path.stem)
    except ScriptError as error:
        raise ScriptError(f"{path.name}: {error}") from None


def recordings(lines: Iterable[ScriptLine], script: Path, folder: Path) -> dict[str, Path]:
    """The recording of each line by its id: the file that the script names, else the one called as the line, else for
    lines with times the one called as the script. Names are compared without their endings and capitals."""
    there = {each.stem.casefold(): each for each in sorted(folder.rglob("*")) if each.suffix.lower() in _SOUNDS}
    found = {}
    for line in lines:
        names = (Path(line.audio.replace("\\", "/")).stem, line.id, script.stem if line.start_s is not None else "")
        path = next((there[name.casefold()] for name in names if name and name.casefold() in there), None)
        if path is not None:
            found[line.id] = path
    return found


def _text(content: bytes) -> str:
    """The file's text: UTF-8, else as Windows writes it in western Europe."""
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252", errors="replace")
