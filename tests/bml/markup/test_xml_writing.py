"""What is written is read again as it was: any document of either dialect, made from the table of elements."""

from collections.abc import Mapping
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from tests.support.examples import examples
from understudy.bml.markup.documents import (
    Document,
    Element,
    Reference,
    Value,
)
from understudy.bml.markup.elements import BML_CORE, CORE, SMARTBODY, Attribute, Dialect, ElementKind, ValueKind
from understudy.bml.reading.reader import read_bml
from understudy.bml.writing.writer import to_xml
from understudy.model.formats import DialectName

CHARACTERS = st.characters(exclude_categories=["Cs", "Cc"], exclude_characters="\ufffe\uffff")
TEXTS = st.text(CHARACTERS, max_size=8).map(lambda text: f"a{text}")
VALUES = TEXTS.map(lambda text: " ".join(text.split()))
NUMBERS = st.floats(min_value=0, max_value=1e9).map(lambda number: number + 0.0)
OF_KINDS: Mapping[ValueKind, st.SearchStrategy[Value]] = {
    ValueKind.TEXT: VALUES,
    ValueKind.NUMBER: NUMBERS,
    ValueKind.SHARE: st.floats(min_value=0, max_value=1),
    ValueKind.COUNT: st.integers(0, 999_999_999),
    ValueKind.TIME: st.just(Reference("s", "w")),
}


@st.composite
def documents(draw: st.DrawFn, dialect: Dialect) -> Document:
    """A block with a speech and any other behaviours, all ids different, all points told from one mark and in order."""
    block = dialect.roots["bml"]
    speech = Element("speech", {"id": "s"}, (Element("text", content=tuple(draw(spoken()))),))
    names = st.sampled_from(sorted(block.parts.keys() - {"speech", "required", "constraint"}))
    kinds = [block.parts[name] for name in draw(st.lists(names, max_size=4))]
    parts = [draw(behaviors(kind, f"b{number}")) for number, kind in enumerate(kinds)]
    others = draw(st.lists(foreign(), max_size=2))
    root = Element("bml", {"id": "bml1"}, (speech, *parts, *others))
    if dialect is SMARTBODY and draw(st.booleans()):
        root = Element("act", content=(Element("participant", {"id": "a"}), root))
    return Document(dialect.name, root)


@st.composite
def spoken(draw: st.DrawFn) -> list[Element | str]:
    return [Element("sync", {"id": "w"}), draw(TEXTS)]


@st.composite
def behaviors(draw: st.DrawFn, kind: ElementKind, name: str) -> Element:
    attributes: dict[str, Value] = {}
    for key, attribute in kind.attributes.items():
        if key not in kind.syncs and (attribute.required or draw(st.booleans())):
            attributes[key] = name if attribute.kind is ValueKind.ID else draw(values(attribute))
    offsets = sorted(draw(st.lists(NUMBERS, min_size=len(kind.syncs), max_size=len(kind.syncs))))
    syncs = {sync: Reference("s", "w", offset) for sync, offset in zip(kind.syncs, offsets, strict=True)}
    attributes |= {key: value for key, value in draw(foreign()).attributes.items() if key.startswith("{")}
    return Element(kind.name, attributes | syncs)


def values(attribute: Attribute) -> st.SearchStrategy[Value]:
    return st.sampled_from(sorted(attribute.one_of)) if attribute.one_of else OF_KINDS[attribute.kind]


@st.composite
def foreign(draw: st.DrawFn) -> Element:
    """An element of an extension, with an attribute of another, text, and elements in no namespace."""
    attributes: dict[str, Value] = {"a": draw(VALUES), "{urn:other}b": draw(VALUES)}
    return Element("{urn:ours}thing", attributes, (draw(TEXTS), Element("inner", {}, (" \n ", Element("{urn:ours}x")))))


@pytest.mark.parametrize("dialect", [BML_CORE, SMARTBODY], ids=lambda dialect: dialect.name)
@given(random=st.data())
@examples(60)
def test_any_document_is_read_as_it_was_written(dialect: Dialect, random: st.DataObject) -> None:
    document = random.draw(documents(dialect))
    written = to_xml(document)
    again, _ = read_bml(written, Path("take.bml"))
    assert again == document
    assert to_xml(again) == written
    assert b"&#" not in written
    etree.fromstring(written)


def test_attributes_come_in_the_order_of_the_table() -> None:
    head = Element("head", {"end": 1.0, "start": 0.0, "lexeme": "NOD", "id": "h"})
    written = to_xml(Document(DialectName.BML, Element("bml", {"id": "b"}, (head,)))).decode()
    assert '<head id="h" lexeme="NOD" start="0.000" end="1.000"/>' in written


def test_numbers_are_fixed_and_exact() -> None:
    for number in (1e-5, 1e22, 0.1 + 0.2, 1 / 3):
        wait = Element("wait", {"id": "w", "max-wait": number})
        written = to_xml(Document(DialectName.BML, Element("bml", {"id": "b"}, (wait,))))
        text = etree.fromstring(written)[0].get("max-wait", "")
        assert float(text) == number
        assert "e" not in text


def test_what_xml_cannot_hold_is_replaced() -> None:
    text = Element("text", content=("a\x00b\ufffe",))
    block = Element("bml", {"id": "b"}, (Element("speech", {"id": "s"}, (text,)),))
    (found,) = etree.fromstring(to_xml(Document(DialectName.BML, block))).iter(f"{{{CORE}}}text")
    assert found.text == "a\ufffdb\ufffd"
