"""Reads screenplays: Fountain with screenplay-tools, Final Draft's FDX with lxml.

A speech is a line: the words under a character's name up to the next element that is not speech; parentheticals and the
extension of the name ("V.O.") are comments. The id of a speech is its scene and its number in it, or the one given in a
note (`[[id: a12]]`). screenplay-tools reads FDX too, but only the first run of text of each paragraph, so that words
after an italic one are lost, and no dual dialogue.
"""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import count
from pathlib import Path

from lxml import etree
from screenplay_tools.fountain.parser import Parser
from screenplay_tools.screenplay import Character, Dialogue, Element, Lyric, Parenthetical, SceneHeading

from ...errors import UndecodableError
from ..model import Script, ScriptLine
from .sheets import without_doubles
from .text_files import cue_name, decode_text, numbered

_NOTE = re.compile(r"\[\[(\d+)\]\]")
_ID_NOTE = re.compile(r"\s*id\s*[:=]\s*(\S+)\s*", re.IGNORECASE)
_EMPHASIS = re.compile(r"(?<!\\)(?:\*{1,3}|_)")


@dataclass(frozen=True, slots=True)
class Paragraph:
    """A paragraph of a screenplay: "scene" (its number, if it has one), "name", "aside", "words" or "other"."""

    kind: str
    text: str = ""
    row: int = 0
    id: str = ""


def read_fountain(content: bytes, path: Path, _named: Mapping[str, str]) -> Script:
    """The script in a Fountain file; raises UndecodableError `text_not_utf8`."""
    file = decode_text(content, str(path))
    parser = Parser()
    parser.mergeDialogue = False
    parser.add_text(file.text)
    notes = [note.text_raw for note in parser.script.notes]
    rows = _Rows(file.text.splitlines())
    parts = [_part(element, notes, rows) for element in parser.script.elements]
    return _script(path, parts, [file.remark] if file.remark else [])


def read_fdx(content: bytes, path: Path, _named: Mapping[str, str]) -> Script:
    """The script in a Final Draft file; raises UndecodableError `screenplay_undecodable`."""
    try:
        root = etree.fromstring(content, etree.XMLParser(resolve_entities=False, no_network=True))
    except etree.XMLSyntaxError as error:
        message = f"{path}: not a Final Draft file: {error.msg}"
        raise UndecodableError("screenplay_undecodable", message, field="script") from None
    return _script(path, [_fdx_part(paragraph) for paragraph in root.iterfind("Content//Paragraph")], [])


def _script(path: Path, parts: Iterable[Paragraph], remarks: Sequence[str]) -> Script:
    lines, doubles = without_doubles(numbered(_speeches(parts)), "")
    return Script(path, lines, tuple(doubles), tuple(remarks))


def _speeches(parts: Iterable[Paragraph]) -> Iterator[ScriptLine]:
    """The speeches with words, in order; scenes without a number are numbered from 1."""
    numbers = (str(number) for number in count(1))
    scene = ""
    speech: list[Paragraph] = []
    for part in [*parts, Paragraph("other")]:
        if part.kind in {"aside", "words"} and speech:
            speech.append(part)
            continue
        if any(each.kind == "words" for each in speech):
            scene = scene or next(numbers)
            yield _line(speech, scene)
        speech = [part] if part.kind == "name" else []
        if part.kind == "scene":
            number = next(numbers)
            scene = part.text or number


def _line(speech: Sequence[Paragraph], scene: str) -> ScriptLine:
    name, beside = cue_name(speech[0].text)
    words = [part for part in speech if part.kind == "words"]
    asides = [part.text for part in speech if part.kind == "aside"]
    return ScriptLine(
        row=speech[0].row,
        id=next((part.id for part in words if part.id), ""),
        text=" ".join(" ".join(part.text for part in words).split()),
        character=name,
        comment="; ".join(each for each in (beside, *asides) if each),
        scene=scene,
    )


class _Rows:
    """Finds the row of a cue in the file, which the parser does not report."""

    def __init__(self, lines: Sequence[str]) -> None:
        self._lines = lines
        self._next = 0

    def of(self, name: str) -> int:
        for place in range(self._next, len(self._lines)):
            before, found, after = self._lines[place].strip().lstrip("@").partition(name)
            if found and not before and after.strip()[:1] in {"", "(", "^"}:
                self._next = place + 1
                return place + 1
        return self._next


def _part(element: Element, notes: Sequence[str], rows: _Rows) -> Paragraph:
    match element:
        case SceneHeading():
            return Paragraph("scene", element.scene_number or "")
        case Character():
            beside = f" ({element.extension})" if element.extension else ""
            return Paragraph("name", f"{element.name}{beside}", rows.of(element.name))
        case Parenthetical():
            return Paragraph("aside", element.text.strip())
        case Dialogue() | Lyric():
            ids = [_ID_NOTE.fullmatch(notes[int(number)]) for number in _NOTE.findall(element.text_raw)]
            return Paragraph("words", _plain(element.text), id=next((match[1] for match in ids if match), ""))
        case _:
            return Paragraph("other")


def _plain(text: str) -> str:
    """The text without Fountain's emphasis marks; escaped ones are kept."""
    return _EMPHASIS.sub("", text).replace("\\*", "*").replace("\\_", "_")


def _fdx_part(paragraph: "etree._Element") -> Paragraph:
    """The part for a paragraph of Final Draft, which has a separate run of text for each style."""
    text = "".join(run.text or "" for run in paragraph.iterfind("Text"))
    row: int = paragraph.sourceline or 0  # type: ignore[assignment]  # lxml-stubs leave it open
    match paragraph.get("Type"):
        case "Scene Heading":
            return Paragraph("scene", paragraph.get("Number") or "")
        case "Character":
            return Paragraph("name", text, row)
        case "Parenthetical":
            return Paragraph("aside", text.strip().removeprefix("(").removesuffix(")").strip())
        case "Dialogue" | "Singing":
            return Paragraph("words", text)
        case _:
            return Paragraph("other")
