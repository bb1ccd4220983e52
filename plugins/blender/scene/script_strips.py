"""The lines of a script as sound strips: custom properties have each one's words (`text`) and speaker (`character`)."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from ..scripts.model import ScriptError, ScriptLine
from .sounds import frame_rate_hz, place_strip


def lay_script(scene: Any, lines: Sequence[ScriptLine], files: Mapping[str, Path], pause_s: float) -> tuple[str, ...]:
    """Adds the lines from the current frame on: those with times at their times, the others one after the other;
    returns the warnings to show. Raises ScriptError where no line has a recording, NoRecordingError where one cannot be
    played."""
    if not files:
        ids = ", ".join(line.id for line in lines[:3])
        raise ScriptError(f"no recording is called as a line of the script ({ids} …): choose their folder")
    rate_hz, begin, messages = frame_rate_hz(scene), scene.frame_current, list[str]()
    frame = float(begin)
    for line in lines:
        if line.id not in files:
            messages.append(f"{line.id} has no recording and is left out")
            continue
        at = frame if line.start_s is None else begin + line.start_s * rate_hz
        part_s = None if line.start_s is None or line.end_s is None else (line.start_s, line.end_s)
        strip = place_strip(scene, files[line.id], round(at), line.id, part_s)
        strip["text"], strip["character"] = line.text, line.character
        frame = strip.frame_final_end + pause_s * rate_hz
    return tuple(messages)
