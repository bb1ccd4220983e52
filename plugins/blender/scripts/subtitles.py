"""Subtitles (SRT): each cue is a line, cut out of one recording by its times."""

import re
from collections.abc import Iterator

from .model import ScriptError, ScriptLine

_TIMES = re.compile(
    r"(\d+):(\d{2}):(\d{2})[,.](\d{1,3})\s*-->\s*(\d+):(\d{2}):(\d{2})[,.](\d{1,3})"  # hours may have more digits
)
_NAME = re.compile(r"(?P<name>[A-Z][\w .'’&-]{0,40}?)\s*:\s+(?P<words>\S.*)", re.DOTALL)
_NOT_SPOKEN = re.compile(r"<[^>]*>|\{\\[^}]*\}|\[[^\]]*\]|\([^)]*\)|[♪♫#]+")


def read_subtitles(content: str, name: str) -> tuple[ScriptLine, ...]:
    """The cues that have words, "ANNA: No." with who says them. Raises ScriptError where there are none."""
    found = tuple(_lines(content, name))
    if not found:
        raise ScriptError("there is no cue with words, as '00:00:01,000 --> 00:00:03,500' and the words below it")
    return found


def _lines(content: str, name: str) -> Iterator[ScriptLine]:
    for number, block in enumerate(re.split(r"\n\s*\n", content.replace("\r\n", "\n").strip()), start=1):
        times = _TIMES.search(block)
        if times is None:
            continue
        words = " ".join(_NOT_SPOKEN.sub(" ", block[times.end() :]).split())
        named = _NAME.fullmatch(words)
        speaker, text = (named["name"], named["words"]) if named else ("", words)
        start_s, end_s = _seconds(times.groups()[:4]), _seconds(times.groups()[4:])
        if text and start_s < end_s:
            yield ScriptLine(f"{name}_{number:04}", text, speaker.strip(), start_s, end_s)


def _seconds(parts: tuple[str | None, ...]) -> float:
    hours, minutes, seconds, fraction = (str(part) for part in parts)
    return int(hours) * 3600 + int(minutes) * 60 + int(seconds) + float(f"0.{fraction}")
