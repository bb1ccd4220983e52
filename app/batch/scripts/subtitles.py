"""Reads subtitles: SRT with `srt`, WebVTT with `webvtt-py`. Each cue is a line, cut out of one long recording by its
times.

Rows are numbers of cues, from 1. The speaker is named before the words ("ANNA: No.") or in a voice span (`<v Anna>`).
Cues without words ("[door slams]", "♪") are skipped.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

import srt
import webvtt
from webvtt.errors import MalformedCaptionError, MalformedFileError

from ...errors import UndecodableError
from ...model import Interval
from ..model import RowProblem, Script, ScriptLine
from .sheets import without_doubles
from .text_files import decode_text, spoken, with_name, without_tags


@dataclass(frozen=True, slots=True)
class Cue:
    """A cue, times in seconds; `voice` and `name` are empty if it has none."""

    start_s: float
    end_s: float
    text: str
    voice: str = ""
    name: str = ""


def read_srt(content: bytes, path: Path, _named: Mapping[str, str]) -> Script:
    """The cues of an SRT file. Raises UndecodableError `text_not_utf8`, `subtitles_undecodable`."""
    file = decode_text(content, str(path))
    try:
        found = list(srt.parse(file.text))
    except (srt.SRTParseError, ValueError, OverflowError) as error:
        message = f"{path}: not an SRT file: {str(error).splitlines()[0]}"
        raise UndecodableError("subtitles_undecodable", message, field="script") from None
    cues = [Cue(cue.start.total_seconds(), cue.end.total_seconds(), cue.content) for cue in found]
    return _script(path, cues, file.remark)


def read_webvtt(content: bytes, path: Path, _named: Mapping[str, str]) -> Script:
    """The cues of a WebVTT file. Raises UndecodableError `text_not_utf8`, `subtitles_undecodable`."""
    file = decode_text(content, str(path))
    try:
        found = webvtt.from_string(file.text, strict=True).captions
    except (MalformedFileError, MalformedCaptionError) as error:
        message = f"{path}: not a WebVTT file: {error}"
        raise UndecodableError("subtitles_undecodable", message, field="script") from None
    return _script(path, [_cue(caption) for caption in found], file.remark)


def _cue(caption: webvtt.Caption) -> Cue:
    start, end = (
        3600 * time.hours + 60 * time.minutes + time.seconds + time.milliseconds / 1000
        for time in (caption.start_time, caption.end_time)
    )
    return Cue(start, end, caption.text, caption.voice or "", caption.identifier or "")


def _script(path: Path, cues: Iterable[Cue], remark: str) -> Script:
    lines, problems = [], []
    silent = 0
    for number, cue in enumerate(cues, start=1):
        line = _line(number, cue, path)
        if not line.text:
            silent += 1
        elif cue.start_s >= cue.end_s:
            message = f"ends at {cue.end_s:.3f} s, before it begins"
            problems.append(RowProblem(number, "", "value_wrong", message, line.id))
        else:
            lines.append(line)
    kept, doubles = without_doubles(lines, "")
    remarks = [remark, f"{silent} cues without words are skipped" if silent else ""]
    return Script(path, kept, (*problems, *doubles), tuple(each for each in remarks if each))


def _line(number: int, cue: Cue, path: Path) -> ScriptLine:
    name, words = with_name(without_tags(cue.text))
    return ScriptLine(
        row=number,
        id=cue.name or f"{path.stem}_{number:04}",
        text=spoken(words),
        character=cue.voice or name,
        interval=Interval(cue.start_s, cue.end_s),
    )
