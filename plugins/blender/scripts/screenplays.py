"""Screenplays in Fountain: a speech is a line, by the name above it; scenes count from their headings.

A speech's id is its scene and its number in it (`scene2_014`), or the one in a note of it (`[[id: a12]]`), as
`understudy batch` has them, so that recordings go by the same names.
"""

import re
from collections import Counter
from collections.abc import Iterator

from .model import ScriptError, ScriptLine

_UNSEEN = re.compile(r"/\*.*?\*/", re.DOTALL)
_TITLE_PAGE = re.compile(r"(?:[A-Za-z][\w ]*:.*\n(?:[ \t]+.*\n)*)+\n")
_HEADING = re.compile(r"(?:\.(?!\.)|(?:INT|EXT|EST|INT\./EXT|I/E)[. ])", re.IGNORECASE)
_CUE = re.compile(r"(?:@(?P<forced>[^(^]+)|(?P<plain>[^a-zß-öø-ÿ(^]*[^\W\d_][^a-zß-öø-ÿ(^]*))\s*(?:\([^)]*\)\s*)*\^?")
_SCENE_NUMBER = re.compile(r"#([\w.-]+)#\s*$")
_ID = re.compile(r"\[\[\s*id\s*[:=]\s*(\S+?)\s*\]\]", re.IGNORECASE)
_ASIDE = re.compile(r"\[\[.*?\]\]|\([^)]*\)", re.DOTALL)
_EMPHASIS = re.compile(r"(?<!\\)(?:\*{1,3}|_)")


def read_screenplay(content: str, _name: str) -> tuple[ScriptLine, ...]:
    """The speeches of a screenplay. Raises ScriptError where there are none."""
    text = _UNSEEN.sub("", content.replace("\r\n", "\n")).lstrip("\n")
    title = _TITLE_PAGE.match(text)
    found = tuple(_speeches(text[title.end() :] if title else text))
    if not found:
        raise ScriptError("there is no speech: a name in capitals, and the words below it")
    return found


def _speeches(text: str) -> Iterator[ScriptLine]:
    scenes, scene, spoken = 0, "1", Counter[str]()
    for block in re.split(r"\n[ \t]*\n", text.strip()):
        first, _, words = block.strip().partition("\n")
        if _HEADING.match(first):
            scenes += 1
            numbered = _SCENE_NUMBER.search(first)
            scene = numbered[1] if numbered else str(scenes)
            continue
        cue = _CUE.fullmatch(first.strip())
        said = " ".join(_unmarked(_ASIDE.sub(" ", words)).split())
        if cue and said and not first.startswith((">", "!", "~")):
            spoken[scene] += 1
            given = _ID.search(block)
            name = given[1] if given else f"scene{scene}_{spoken[scene]:03}"
            yield ScriptLine(name, said, (cue["forced"] or cue["plain"]).strip())


def _unmarked(words: str) -> str:
    """The words without marks of emphasis; an escaped mark is itself."""
    return re.sub(r"\\([*_])", r"\1", _EMPHASIS.sub("", words))
