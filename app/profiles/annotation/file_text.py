"""Reads the text of annotation files: their encoding, and XML with the line of each element."""

from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from math import isfinite
from pathlib import Path

from lxml import etree

from .mistakes import AnnotationError, AnnotationMistake


def decoded(content: bytes, path: Path) -> str:
    """The text without its mark; raises AnnotationError with the place of the first byte that is none."""
    encoding = "utf-16" if content.startswith((BOM_UTF16_BE, BOM_UTF16_LE)) else "utf-8-sig"
    try:
        return content.decode(encoding)
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        message = f"line {line}: byte {error.start} is not {encoding.upper().removesuffix('-SIG')}; save it as UTF-8"
        raise AnnotationError([AnnotationMistake(path, message)]) from None


def xml_root(content: bytes, path: Path, expected: str) -> etree._Element:
    """The root of a document, which must be called `expected`, names without their namespaces; raises
    AnnotationError."""
    parser = etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False)
    try:
        root = etree.fromstring(content, parser)
    except etree.XMLSyntaxError as error:
        raise AnnotationError([AnnotationMistake(path, f"not XML: {error.msg}")]) from None
    for element in root.iter("{*}*"):
        element.tag = etree.QName(element).localname
    if root.tag != expected:
        raise AnnotationError([AnnotationMistake(path, f"the document is <{root.tag}>; <{expected}> is expected")])
    return root


def number_of(element: etree._Element, name: str) -> float | None:
    """An attribute as a number; None where it is missing or none."""
    try:
        number = float(element.get(name, ""))
    except ValueError:
        return None
    return number if isfinite(number) else None
