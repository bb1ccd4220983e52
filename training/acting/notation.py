"""A short notation in which a director writes readings of lines down, and the records it becomes.

    == banter                                       the kind of what follows
    B You paid forty for this?                      a line that is said in several deliveries
    > this amu 0 0,0 | holds it up to the light     focus, tone, loudness, size and speed, what is meant
    paid..this@this 3 present,point_here t.bu.T this thing
    ! forty count not counted out                   what would be wrong
    L You paid what?                                a line with one reading, in its likeliest way

A moment is a span (`first..last@stroke`, the stroke being the last word where it is not given), its importance, the
families of gestures, the best first, codes of head, face and gaze, and the idea. Words are named by themselves or by
their beginnings, the second `the` as `the#2`; a span that could be several is the shortest that holds
its stroke. `-` is nothing.
"""

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

# fmt: off
_NAMES = (
    "self addressee group point_here point_there point_up negation stop_refuse question shrug present offer_give "
    "size_big size_small shape count list_item all_sweep none_empty precision beat chop fist contrast_sides "
    "compare_levels up down left right forward back approach away through_path cycle turn_over_change begin end_cut "
    "join separate contain_in out past future now think heart accept dismiss greet farewell thanks apologise please "
    "quote word_search weigh emblem_other still"
)
FAMILIES = frozenset(_NAMES.split())
SHORT_FAMILIES = {
    "adr": "addressee", "ph": "point_here", "pt": "point_there", "pu": "point_up", "neg": "negation",
    "stop": "stop_refuse", "q": "question", "pre": "present", "give": "offer_give", "big": "size_big",
    "small": "size_small", "list": "list_item", "sweep": "all_sweep", "none": "none_empty", "prec": "precision",
    "con": "contrast_sides", "cmp": "compare_levels", "path": "through_path", "turn": "turn_over_change",
    "end": "end_cut", "contain": "contain_in", "emb": "emblem_other", "ws": "word_search", "shr": "shrug",
    "sorry": "apologise",
}
CHANNELS = {
    "head": {"n": "nod", "s": "shake", "t": "tilt", "x": "toss", "u": "turn", "li": "lean_in", "lb": "lean_back",
             "st": "still"},
    "face": {"bu": "brows_up", "fr": "frown", "sm": "smile", "sq": "squint", "we": "wide_eyes", "lp": "lips_pressed",
             "dg": "disgust", "sd": "sad", "ne": "neutral"},
    "gaze": {"L": "listener", "A": "away", "U": "up", "D": "down", "T": "target"},
}
TONES = {
    each[:3]: each
    for each in ("neutral", "amused", "angry", "commanding", "tender", "sad", "weary", "afraid", "excited", "hesitant",
                 "happy", "disgusted")
}
# fmt: on
AVOIDABLE = FAMILIES | {name for names in CHANNELS.values() for name in names.values()}


class NotationError(ValueError):
    """Lines of notation that cannot be read; the message says where and why."""


@dataclass(slots=True)
class _Page:
    """What has been read so far."""

    writer: str
    kind: str = ""
    base: str = ""
    words: list[str] = field(default_factory=list)
    counts: dict[str, int] = field(default_factory=dict)
    letters: int = 0
    records: list[dict[str, Any]] = field(default_factory=list)


def records_of(path: Path, writer: str, counts: dict[str, int]) -> list[dict[str, Any]]:
    """The records of the notation in `path`; `writer` marks the names, `counts` numbers on by kind over several files.

    Raises NotationError if lines cannot be read: each with its file, number and reason.
    """
    page, wrong = _Page(writer, counts=counts), []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if line.strip() and not line.startswith("//"):
            try:
                _read(page, line.strip())
            except (ValueError, KeyError, IndexError) as error:
                wrong.append(f"{path}:{number}: {error} in {line!r} ({' '.join(page.words)})")
    if wrong:
        raise NotationError("\n".join(wrong))
    for record in page.records:
        record["moments"].sort(key=lambda moment: (moment["stroke"], moment["first"]))
    return page.records


def _read(page: _Page, line: str) -> None:
    mark, _, rest = line.partition(" ")
    match mark:
        case "==":
            page.kind = rest
        case "B" | "L":
            _open_line(page, rest, single=mark == "L")
        case ">":
            _open_delivery(page, rest)
        case "!":
            page.records[-1]["avoid"].append(_avoided(page.words, rest))
        case _:
            page.records[-1]["moments"].append(_moment(page.words, line))


def _open_line(page: _Page, text: str, *, single: bool) -> None:
    page.words, page.letters = text.split(), 0
    page.counts[page.kind] = page.counts.get(page.kind, 0) + 1
    page.base = f"{page.kind}{page.writer}-{page.counts[page.kind]:03}"
    if single:
        page.records.append({"id": page.base, "source": page.kind, "text": text, "moments": [], "avoid": []})


def _open_delivery(page: _Page, rest: str) -> None:
    how, note = rest.split("|", 1)
    focus, tone, loudness, manner = how.split()
    size, speed = (int(each) for each in manner.split(","))
    letter = "abcdefgh"[page.letters]
    page.letters += 1
    page.records.append({
        "id": f"{page.base}-{letter}", "base": page.base, "source": page.kind, "text": " ".join(page.words),
        "focus": sorted(_only(page.words, word) for word in focus.split(",")), "tone": TONES[tone],
        "loudness": int(loudness), "note": note.strip(), "moments": [], "avoid": [],
        "manner": {"size": size, "speed": speed},
    })  # fmt: skip


def _moment(words: list[str], line: str) -> dict[str, Any]:
    span, importance, families, codes, idea = line.split(" ", 4)
    first, last, stroke = _span(words, span)
    moment: dict[str, Any] = {"first": first, "last": last, "stroke": stroke, "importance": int(importance)}
    moment |= {"idea": idea, "gesture": [_family(each) for each in families.split(",") if families != "-"]}
    named = codes.split(".") if codes != "-" else []
    for channel, names in CHANNELS.items():
        moment[channel] = [names[code] for code in named if code in names]
    unknown = [code for code in named if all(code not in names for names in CHANNELS.values())]
    if unknown or moment["importance"] not in (1, 2, 3):
        raise ValueError(unknown or importance)
    return moment


def _avoided(words: list[str], rest: str) -> dict[str, Any]:
    span, what, *why = rest.split(" ", 2)
    first, last, _ = _span(words, span)
    wrong = [SHORT_FAMILIES.get(each, each) for each in what.split(",")]
    if not AVOIDABLE.issuperset(wrong):
        raise ValueError(what)
    return {"first": first, "last": last, "what": wrong} | ({"why": why[0]} if why else {})


def _family(name: str) -> str:
    family = SHORT_FAMILIES.get(name, name)
    if family not in FAMILIES:
        raise ValueError(name)
    return family


def _span(words: list[str], span: str) -> tuple[int, int, int]:
    ends, _, stroke = span.partition("@")
    first, _, last = ends.partition("..")
    starts = _all(words, first)
    found = [(start, end) for start in starts for end in (_all(words, last) if last else [start])]
    found = [(start, end) for start, end in found if start < end or not last]
    strokes = _all(words, stroke) if stroke else [end for _, end in found]
    spans = [(start, end, at) for start, end in found for at in strokes if start <= at <= end and (stroke or at == end)]
    shortest = min((end - start for start, end, _ in spans), default=0)
    spans = [each for each in spans if each[1] - each[0] == shortest]
    if len(set(spans)) != 1:
        raise ValueError(f"{len(spans)} spans {span}")
    return spans[0]


def _only(words: list[str], name: str) -> int:
    found = _all(words, name)
    if len(found) != 1:
        raise ValueError(f"{len(found)} words {name}")
    return found[0]


def _all(words: list[str], name: str) -> list[int]:
    name, _, place = name.partition("#")
    wanted = _plain(name)
    plain = [_plain(word) for word in words]
    found = [at for at, word in enumerate(plain) if word == wanted]
    found = found or [at for at, word in enumerate(plain) if wanted and word.startswith(wanted)]
    return [found[int(place) - 1]] if place else found


def _plain(word: str) -> str:
    return re.sub(r"[^a-z0-9]", "", word.casefold())
