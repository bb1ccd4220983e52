"""The text of a file, however it was saved: UTF-8, or UTF-16 with its mark, as Praat and spreadsheets write it."""

from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from pathlib import Path

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
