"""The kept behaviours of a performance as BML, in the dialect and with the times that were asked for (shared/bml.md).

`app.bml.blocks` and `app.bml.smartbody` say what goes into a document, `app.bml.markup` how it looks as XML and
`app.bml.json_form` as JSON.
"""

from dataclasses import dataclass

from app.bml.blocks import to_core
from app.bml.documents import DialectName, Document, TimeForm
from app.bml.json_form import to_json
from app.bml.markup import to_xml
from app.bml.smartbody import to_smartbody
from app.model import Performance


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
