"""The recorded speech in SmartBody's dialect: the element in the act, and the file it requires beside the audio.

SmartBody finds a recording by `ref`, the name of its files without extension: NAME.wav is played, and NAME.bml beside
it has the word times (`sync`) and visemes (`lips`); without visemes there it refuses the speech. It copies the element
as text without escaping it, so that `&`, `<` and `>` in it cut it off.
"""

from collections.abc import Iterator, Mapping

from ...model import Performance, Viseme, Word
from ...model.formats import DialectName, TimeForm
from ...model.tables import SILENCE
from ..markup.documents import Document, Element, Value
from ..markup.speech import SPEECH, to_milli
from .smartbody_tables import SmartBodyMouthShape

UNSAFE = "&<>"
"""The characters on which SmartBody's second reading of the speech fails."""

_WITHOUT_UNSAFE = str.maketrans(dict.fromkeys(UNSAFE))
_WITH_MARKS = "application/ssml+xml"
"""The type of a speech whose `mark` elements are sync points."""


def safe(text: str) -> str:
    """The text without the characters on which SmartBody fails."""
    return text.translate(_WITHOUT_UNSAFE)


def first_mark(word_index: int) -> str:
    """The id of the mark before a word; the mark after it has the next number."""
    return f"T{2 * word_index}"


def speech_element(performance: Performance, timing: TimeForm, ref: str | None) -> Element:
    """The speech in the act. Only marks directly inside it are sync points for other behaviours."""
    start_s = performance.utterance.lead_in_s
    named: dict[str, Value] = {"id": SPEECH, **({"ref": ref} if ref else {})}
    begun = {"start": to_milli(start_s)}
    marked = tuple(_marked(performance.utterance.words, start_s, timing))
    if timing is TimeForm.SYNC:
        return Element("speech", {**named, "type": _WITH_MARKS, **begun}, marked)
    return Element("speech", {**named, **begun}, (Element("text", content=marked),))


def speech_file(performance: Performance, shapes: Mapping[str, SmartBodyMouthShape]) -> Document:
    """The file beside the recording, in seconds of the recording. If the mouth never moves, a closed one is written,
    because SmartBody requires a viseme."""
    lead_in_s = performance.utterance.lead_in_s
    text = Element("text", content=tuple(_marked(performance.utterance.words, lead_in_s, TimeForm.ABSOLUTE)))
    shown = [shape for shape in performance.visemes if shape.label != SILENCE]
    lips = [_lips(shape, shapes[shape.label], lead_in_s) for shape in shown]
    content = (Element("speech", {"id": SPEECH}, (text,)), *(lips or [_shut(next(iter(shapes.values())))]))
    return Document(DialectName.SMARTBODY, Element("bml", content=content))


def _marked(words: tuple[Word, ...], start_s: float, timing: TimeForm) -> Iterator[Element | str]:
    """Every timed word between marks at its start and its end, in seconds from the start of the speech."""
    kind, naming = ("mark", "name") if timing is TimeForm.SYNC else ("sync", "id")
    for word in words:
        if word.interval is None:
            yield f"{safe(word.text)} "
            continue
        yield Element(kind, {naming: first_mark(word.index), "time": to_milli(word.interval.start_s - start_s)})
        yield f"{safe(word.text)} "
        end_s = to_milli(word.interval.end_s - start_s)
        yield Element(kind, {naming: f"T{2 * word.index + 1}", "time": end_s})


def _lips(viseme: Viseme, shape: SmartBodyMouthShape, lead_in_s: float) -> Element:
    """A viseme rises over its first quarter and decays over its last."""
    start_s, end_s = viseme.interval.start_s - lead_in_s, viseme.interval.end_s - lead_in_s
    quarter_s = viseme.interval.duration_s / 4
    syncs = {"start": start_s, "ready": start_s + quarter_s, "relax": end_s - quarter_s, "end": end_s}
    times = {name: to_milli(time_s) for name, time_s in syncs.items()}
    return Element("lips", {"viseme": shape.name, "articulation": to_milli(viseme.articulation * shape.share), **times})


def _shut(shape: SmartBodyMouthShape) -> Element:
    times = {"start": 0.0, "ready": 0.0, "relax": 0.1, "end": 0.1}
    return Element("lips", {"viseme": shape.name, "articulation": 0.0, **times})
