"""XML of annotation tools, read without entities, network or document types."""

from pathlib import Path

from lxml import etree

from .mistakes import AnnotationError, AnnotationMistake


def xml_root(content: bytes, path: Path, expected: str) -> etree._Element:
    """The root of a document, which must be called `expected`; raises AnnotationError."""
    parser = etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False)
    try:
        root = etree.fromstring(content, parser)
    except etree.XMLSyntaxError as error:
        raise AnnotationError([AnnotationMistake(path, f"not XML: {error.msg}")]) from None
    if root.tag != expected:
        raise AnnotationError([AnnotationMistake(path, f"the document is <{root.tag}>; <{expected}> is expected")])
    return root


def number_of(element: etree._Element, name: str) -> float | None:
    """An attribute as a number; None where it is missing or none."""
    try:
        return float(element.get(name, ""))
    except ValueError:
        return None
