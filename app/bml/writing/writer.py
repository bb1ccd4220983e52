"""Writes the kept behaviours of a performance as BML, in the requested dialect and time form (shared/bml.md).

`understudy.bml.writing.blocks` and `understudy.bml.writing.smartbody` build the document,
`understudy.bml.markup.xml_writing` writes it as XML, `understudy.bml.writing.json_form` as JSON.
"""

from dataclasses import dataclass

from ...model import Performance
from ..markup.documents import DialectName, Document, TimeForm
from ..markup.xml_writing import to_xml
from .blocks import to_core
from .json_form import to_json
from .smartbody import to_smartbody


@dataclass(frozen=True, slots=True)
class BmlForm:
    """The output format. Absolute times are the default, because realizers do not know the word times of recorded
    speech. `audio_name` is the recording's name for SmartBody, which plays it."""

    dialect: DialectName = DialectName.BML
    timing: TimeForm = TimeForm.ABSOLUTE
    audio_name: str | None = None


CORE_FORM = BmlForm()
"""BML 1.0 core with absolute times."""


def write_bml(performance: Performance, form: BmlForm = CORE_FORM) -> bytes:
    """The BML document as UTF-8 XML."""
    return to_xml(to_document(performance, form))


def write_bml_json(performance: Performance, form: BmlForm = CORE_FORM) -> bytes:
    """The same document as UTF-8 JSON (docs/bml-json.md)."""
    return to_json(to_document(performance, form))


def to_document(performance: Performance, form: BmlForm = CORE_FORM) -> Document:
    """The BML document as a value."""
    match form.dialect:
        case DialectName.BML:
            return to_core(performance, form.timing)
        case DialectName.SMARTBODY:
            return to_smartbody(performance, form.timing, audio_name=form.audio_name)
