"""The kept behaviours of a performance as BML, in the dialect and with the times that were asked for (shared/bml.md).

`understudy.bml.writing.blocks` and `understudy.bml.writing.smartbody` say what goes into a document,
`understudy.bml.markup.markup` how it looks as XML and `understudy.bml.writing.json_form` as JSON.
"""

from dataclasses import dataclass

from ...model import Performance
from ..markup.documents import DialectName, Document, TimeForm
from ..markup.markup import to_xml
from .blocks import to_core
from .json_form import to_json
from .smartbody import to_smartbody


@dataclass(frozen=True, slots=True)
class BmlForm:
    """How the BML is to be written. Realizers do not know when the words of recorded speech fall, so absolute times are
    the rule. `audio_name` is the recording's name for SmartBody, which plays it."""

    dialect: DialectName = DialectName.BML
    timing: TimeForm = TimeForm.ABSOLUTE
    audio_name: str | None = None


CORE_FORM = BmlForm()
"""BML 1.0 core with absolute times."""


def write_bml(performance: Performance, form: BmlForm = CORE_FORM) -> bytes:
    """The BML document as XML, UTF-8."""
    return to_xml(to_document(performance, form))


def write_bml_json(performance: Performance, form: BmlForm = CORE_FORM) -> bytes:
    """The same document as JSON, UTF-8 (docs/bml-json.md)."""
    return to_json(to_document(performance, form))


def to_document(performance: Performance, form: BmlForm = CORE_FORM) -> Document:
    """The BML document as a value."""
    match form.dialect:
        case DialectName.BML:
            return to_core(performance, form.timing)
        case DialectName.SMARTBODY:
            return to_smartbody(performance, form.timing, audio_name=form.audio_name)
