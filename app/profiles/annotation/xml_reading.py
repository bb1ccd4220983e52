"""XML of annotation tools, read without entities, network or document types, and without regard to namespaces."""

from math import isfinite
from pathlib import Path

from lxml import etree

from .mistakes import AnnotationError, AnnotationMistake


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
