"""What the formats that are not sheets share: ids of lines, names before words, removal of what is not spoken."""

import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import replace

from ..model import ScriptLine

_BEFORE_WORDS = re.compile(r"(?P<name>[A-Z][\w .'’&-]{0,40}?)\s*:\s+(?P<words>\S.*)", re.DOTALL)
_NOT_SPOKEN = re.compile(r"\[[^\]]*\]|\([^)]*\)|[♪♫#]+")
_TAGS = re.compile(r"<[^>]*>|\{\\[^}]*\}")
_CONTINUED = re.compile(r"\s*\(\s*(?:cont(?:['’]?d|inued)|more)\.?\s*\)\s*", re.IGNORECASE)
_EXTENSION = re.compile(r"\s*\(([^)]*)\)\s*")

PLACES_OF_NUMBER = 3


def without_tags(text: str) -> str:
    """The text without subtitle tags."""
    return _TAGS.sub("", text)


def spoken(text: str) -> str:
    """The text without descriptions of sounds ("[door slams]"), in one line."""
    return " ".join(_NOT_SPOKEN.sub(" ", text).split())


def with_name(text: str) -> tuple[str, str]:
    """A name before the words ("ANNA: No.") and the words; an empty name where there is none."""
    match = _BEFORE_WORDS.fullmatch(text.strip())
    return (match["name"].strip(), match["words"].strip()) if match else ("", text.strip())


def cue_name(cue: str) -> tuple[str, str]:
    """A character's name without its extensions in a screenplay, and the extensions ("V.O.") except "continued"."""
    plain = _CONTINUED.sub(" ", cue).strip()
    return _EXTENSION.sub(" ", plain).strip(), "; ".join(_EXTENSION.findall(plain))


def numbered(lines: Iterable[ScriptLine]) -> tuple[ScriptLine, ...]:
    """The lines, those without an id numbered by scene and place in the scene (`scene2_014`)."""
    count: Counter[str] = Counter()
    named = []
    for line in lines:
        count[line.scene] += 1
        name = line.id or f"scene{line.scene}_{count[line.scene]:0{PLACES_OF_NUMBER}}"
        named.append(replace(line, id=name))
    return tuple(named)
