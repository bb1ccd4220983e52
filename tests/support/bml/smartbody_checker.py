"""What a SmartBody that was built and run accepts of an act and of the file beside its recording.

Facts about SmartBody, not about our writer: its parser of speeches, gestures and sync points, its reader of audio
files, and the gesture map BradGesture of its behaviour set `Gestures`, by type, hand and style, in the posture that its
characters stand in.
"""

import re
from collections.abc import Iterator

from lxml import etree

GESTURES = frozenset(
    (line.split()[0], hand, style)
    for line in """
        RHYTHM L R B; OBLIGATION L R B; YOU L R B; LEFT L L:high; RIGHT R R:high; HERE B B:high; NEGATION R B
        ASIDE L; QUESTION L:noheadtilt B:noheadtilt; INTENSIFIER_POSITIVE B; ME L; WE R; CONTRAST L R
        UNCERTAINTY B; INDIFFERENCE B; INCLUSIVITY B:mid B:low; EMPTY B:high R:high; SURROUND B; GREETING L R
    """.replace("\n", ";").split(";")
    if line.strip()
    for hand, _, style in (entry.partition(":") for entry in line.split()[1:])
)
MODES = {"LEFT_HAND": "L", "RIGHT_HAND": "R", "BOTH_HANDS": "B"}
STYLE = "{http://ict.usc.edu}style"
VISEMES = frozenset({"open", "W", "ShCh", "PBM", "FV", "wide", "tBack", "tRoof", "tTeeth"})
POINTS = ("start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end")
KNOWN = frozenset({"speech", "gesture", "head", "gaze", "face", "saccade", "body"})
HEADS = frozenset({"NOD", "SHAKE", "TOSS"})
MARK = re.compile(r"[A-Za-z][A-Za-z0-9]*")
TIME = re.compile(r"-?\d+(\.\d+)?")
REFERENCE = re.compile(r"(\w+):(\w+)([+-]\d+(\.\d+)?)?")
UNSAFE = re.compile("[&<>]")


def check_act(content: bytes, scene: frozenset[str] = frozenset()) -> list[str]:
    """What SmartBody refuses, breaks off at or does not find; `scene` has the names of its pawns and characters beside
    the actor."""
    root = etree.fromstring(content)
    if [root.tag, *(part.tag for part in root)] != ["act", "participant", "bml"]:
        return [f"the root is {root.tag} with {[part.tag for part in root]}, not an act"]
    block = root[1]
    speeches = block.findall("speech")
    marks = {f"speech1:{name}" for speech in speeches for name in _marks(speech)} | {"speech1:start"}
    return [
        *(f"{part.tag} is unknown" for part in block if part.tag not in KNOWN),
        *(mistake for speech in speeches for mistake in _speech(speech)),
        *(mistake for part in block for mistake in _points(part, marks)),
        *(mistake for gesture in block.iter("gesture") for mistake in _gesture(gesture)),
        *(f"head type {head.get('type')}" for head in block.iter("head") if head.get("type") not in HEADS),
        *(f"gaze at {gaze.get('target')}" for gaze in block.iter("gaze") if gaze.get("target") not in scene),
        *(f"face type {face.get('type')}" for face in block.iter("face") if face.get("type") != "facs"),
    ]


def check_speech_file(content: bytes, act: bytes) -> list[str]:
    """What SmartBody does not find in NAME.bml for the speech of an act."""
    root = etree.fromstring(content)
    times = {sync.get("id", ""): float(sync.get("time", "nan")) for sync in root.findall("speech/text/sync")}
    lips = root.findall("lips")
    starts = [float(each.get("start", "nan")) for each in lips]
    asked = {name for speech in etree.fromstring(act).iter("speech") for name in _marks(speech)}
    return [
        *([] if root.tag == "bml" else [f"the root is {root.tag}"]),
        *([] if times else ["no sync directly in the text of the speech"]),
        *([] if lips else ["no lips, so that the speech is refused"]),
        *(f"no time for {name}" for name in sorted(asked - times.keys())),
        *(f"the sync {name} is before the recording" for name, time_s in times.items() if not time_s >= 0),
        *(f"no mouth has {each.get('viseme')}" for each in lips if each.get("viseme") not in VISEMES),
        *(["lips are not in order"] if starts != sorted(starts) else []),
    ]


def _marks(speech: etree._Element) -> list[str]:
    """The sync points of a speech: marks directly inside it, if it has the type for them."""
    if speech.get("type") != "application/ssml+xml":
        return []
    return [mark.get("name", "") for mark in speech.findall("mark")]


def _speech(speech: etree._Element) -> Iterator[str]:
    if not speech.get("ref"):
        yield "the speech has no ref"
    if any(UNSAFE.search(str(text)) for text in (*speech.itertext(), *speech.attrib.values())):
        yield "the speech has & < or >"
    yield from (f"no mark can be called {name!r}" for name in _marks(speech) if not MARK.fullmatch(name))


def _points(part: etree._Element, marks: set[str]) -> Iterator[str]:
    for name in POINTS:
        told = part.get(name)
        if told is None or TIME.fullmatch(told):
            continue
        reference = REFERENCE.fullmatch(told)
        if reference is None or f"{reference[1]}:{reference[2]}" not in marks:
            yield f"{part.get('id')}: {name} {told} is neither a time nor a mark of the speech"


def _gesture(gesture: etree._Element) -> Iterator[str]:
    if {name for name in POINTS if gesture.get(name) is not None} != {"stroke", "relax"}:
        yield f"{gesture.get('id')}: not exactly stroke and relax"
    asked = gesture.get("type"), MODES.get(gesture.get("mode", "")), gesture.get(STYLE)
    if not any(all(want in (None, has) for want, has in zip(asked, entry, strict=True)) for entry in GESTURES):
        yield f"{gesture.get('id')}: no gesture is {asked}"
    yield from (f"{gesture.get('id')}: {name} is not read" for name in ("style", "emotion") if gesture.get(name))
