"""A performance, an analysis or an alignment as the content of files."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

from ..acoustic.alignment.timings import to_ctm, to_textgrid
from ..bml.writing.writer import SpeechFile, listener_part, speech_file_name, write_listener
from ..bml.writing.writer import write_bml as _write_bml
from ..bml.writing.writer import write_bml_json as _write_bml_json
from ..bml.writing.writer import write_speech_file as _write_speech_file
from ..errors import InputError
from ..model import AlignedLine, Analysis, Performance
from ..model.formats import BmlForm, DialectName, TimeForm, VisemeNames
from ..model.lead_in import with_lead_in
from ..schemas.options import check_options
from ..schemas.response_model import ResponseModel

__all__ = [
    "BmlFiles",
    "listener_part",
    "speech_file_name",
    "write_bml",
    "write_bml_files",
    "write_bml_json",
    "write_ctm",
    "write_json",
    "write_speech_file",
    "write_textgrid",
]


@dataclass(frozen=True, slots=True)
class BmlFiles:
    """A performance as BML: the speaker's, each listener's by name, and the file that SmartBody needs beside them."""

    speaker: bytes
    listeners: Mapping[str, bytes]
    speech: SpeechFile | None


def write_bml_files(performance: Performance, form: BmlForm) -> BmlFiles:
    """The BML of everybody in a performance, in the requested form."""
    return BmlFiles(
        _write_bml(performance, form),
        {each.name: write_listener(performance, each, form) for each in performance.listeners},
        _write_speech_file(performance, form),
    )


def write_bml(
    performance: Performance,
    *,
    dialect: DialectName | Literal["bml", "smartbody"] = DialectName.BML,
    timing: TimeForm | Literal["absolute", "sync"] = TimeForm.ABSOLUTE,
    audio_name: str | None = None,
    bmlt_audio: bool = False,
    listener: str | None = None,
) -> bytes:
    """The schedule as BML, XML in UTF-8 (docs/bml.md), in BML 1.0 or SmartBody's dialect.

    With `timing` "sync", times refer to sync points of the speech instead of being seconds; `audio_name` is the name of
    the recording's file, by which SmartBody (`write_speech_file`) and, with `bmlt_audio`, ASAP find it. With `listener`
    the result is that listener's behaviour instead. Raises InputError `value_wrong`.
    """
    form = replace(_bml_form(dialect, timing, audio_name), bmlt_audio=bmlt_audio)
    if listener is None:
        return _write_bml(performance, form)
    for listening in performance.listeners:
        if listening.name == listener:
            return write_listener(performance, listening, form)
    known = ", ".join(each.name for each in performance.listeners) or "nobody"
    raise InputError("value_wrong", f"no listener is called {listener!r}; {known} listens", field="listener")


def write_speech_file(
    performance: Performance,
    audio_name: str,
    *,
    visemes: VisemeNames | Literal["smartbody", "facefx"] = VisemeNames.SMARTBODY,
) -> bytes:
    """NAME.bml, which SmartBody needs beside NAME.wav: the times of words and visemes, the visemes named as in
    SmartBody's own characters or in FaceFX. `audio_name` is NAME. Raises InputError `value_wrong`."""
    form = check_options({"dialect": DialectName.SMARTBODY, "visemes": visemes}).form
    found = _write_speech_file(performance, replace(form, audio_file=audio_name))
    return found.content if found else b""


def write_bml_json(
    performance: Performance,
    *,
    dialect: DialectName | Literal["bml", "smartbody"] = DialectName.BML,
    timing: TimeForm | Literal["absolute", "sync"] = TimeForm.ABSOLUTE,
    audio_name: str | None = None,
    form: BmlForm | None = None,
) -> bytes:
    """The same document as JSON (docs/bml-json.md); `form` replaces the other arguments."""
    return _write_bml_json(performance, form or _bml_form(dialect, timing, audio_name))


def write_json(found: Performance | Analysis | AlignedLine, *, indent: int | None = None) -> bytes:
    """All of a performance, an analysis or an alignment as JSON, in the schemas of the command line and the service."""
    return _response(found).to_json(indent)


def write_textgrid(found: Performance | Analysis | AlignedLine) -> bytes:
    """The times of words and phones as a Praat TextGrid with the tiers "words" and "phones"."""
    timed = _aligned(found)
    return to_textgrid(timed.words, timed.duration_s).encode()


def write_ctm(found: Performance | Analysis | AlignedLine, name: str = "audio") -> bytes:
    """The times of the words as CTM, one word a line; `name` is the recording's name in it."""
    return to_ctm(_aligned(found).words, name).encode()


def _bml_form(dialect: str, timing: str, audio_name: str | None) -> BmlForm:
    checked = check_options({"dialect": dialect, "timing": timing}).form
    return replace(checked, audio_file=audio_name)


def _aligned(found: Performance | Analysis | AlignedLine) -> AlignedLine:
    """The words with their times in the recording; raises InputError `value_wrong` if there was no recording."""
    if isinstance(found, AlignedLine):
        return found
    utterance = with_lead_in(found.utterance, 0.0)
    if utterance.duration_s is None:
        raise InputError("value_wrong", "nothing was heard, so no word has a time; align or analyze the recording")
    return AlignedLine(utterance.words, utterance.duration_s, found.notices, utterance.fillers)


def _response(found: Performance | Analysis | AlignedLine) -> ResponseModel:
    from ..schemas.responses import AlignResponse, AnalysisResponse, FunctionsResponse, PerformanceResponse

    match found:
        case Performance():
            return PerformanceResponse.of_performance(found)
        case AlignedLine():
            return AlignResponse.of(found)
        case Analysis() if found.utterance.duration_s is None:
            return FunctionsResponse.of(found)
        case Analysis():
            return AnalysisResponse.of(found)
