"""Reads a multipart form into memory: the bytes of each part, without temporary files; and the parts that describe the
speaker: `reference`, how the voice usually sounds, stored or recorded, and `profile`, a gesture profile's file.

The size of the whole is limited where the bytes come in (`understudy.api.bodies`).
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import PurePath
from typing import TYPE_CHECKING

from python_multipart.exceptions import FormParserError
from python_multipart.multipart import MultipartParser, parse_options_header

from ...errors import AuthoringError, InputError, TooLargeError, UndecodableError, UnsupportedFormatError
from ...library.hearing import make_reference
from ...models import Understudy, load_tags
from ...options import Options
from ...profiles.files.reading import read_profile_text
from ...schemas.references import read_reference

if TYPE_CHECKING:
    from python_multipart.multipart import MultipartCallbacks

_PIECE_BYTES = 1 << 16


@dataclass(frozen=True, slots=True)
class FormPart:
    """A field of the form; `file_name` is None when it was sent as a plain value."""

    name: str
    content: bytes
    file_name: str | None

    @property
    def text(self) -> str:
        """The content as text. A surrogate is let through, for the transcript's own check to name it.

        Raises UndecodableError `text_not_utf8`.
        """
        try:
            return self.content.decode("utf-8", "surrogatepass")
        except UnicodeDecodeError as error:
            raise UndecodableError(
                "text_not_utf8", f"{self.name} is not UTF-8 at byte {error.start}; send it as UTF-8", field=self.name
            ) from None


def read_form(content_type: str, content: bytes, limits: Mapping[str, int]) -> dict[str, FormPart]:
    """The parts by name; `limits` has the names that may come, each once, with the most bytes of each.

    Raises UnsupportedFormatError `media_type`, UndecodableError `form_broken`, InputError `field_unknown` and
    `field_repeated`, TooLargeError `field_too_large`.
    """
    media_type, parameters = parse_options_header(content_type)
    if media_type != b"multipart/form-data":
        raise UnsupportedFormatError("media_type", "send multipart/form-data with the fields audio and text")
    collector = _Collector(limits)
    try:
        parser = MultipartParser(parameters.get(b"boundary", b""), collector.callbacks())
        for begin in range(0, len(content), _PIECE_BYTES):
            parser.write(content[begin : begin + _PIECE_BYTES])
    except FormParserError as error:
        raise UndecodableError("form_broken", f"the multipart form cannot be read: {error}") from None
    if not collector.ended:
        raise UndecodableError("form_broken", "the multipart form ends before its closing boundary")
    return collector.parts


class _Collector:
    """Gathers the parts as the parser calls back."""

    def __init__(self, limits: Mapping[str, int]) -> None:
        self.parts: dict[str, FormPart] = {}
        self.ended = False
        self._limits = limits
        self._header_name = b""
        self._header_value = b""
        self._headers: dict[bytes, bytes] = {}
        self._content = bytearray()
        self._name = ""
        self._file_name: str | None = None

    def callbacks(self) -> "MultipartCallbacks":
        return {
            "on_part_begin": self._on_part_begin,
            "on_header_field": self._on_header_field,
            "on_header_value": self._on_header_value,
            "on_header_end": self._on_header_end,
            "on_headers_finished": self._on_headers_finished,
            "on_part_data": self._on_part_data,
            "on_part_end": self._on_part_end,
            "on_end": self._on_end,
        }

    def _on_part_begin(self) -> None:
        self._headers, self._content = {}, bytearray()

    def _on_header_field(self, chunk: bytes, start: int, end: int) -> None:
        self._header_name += chunk[start:end]

    def _on_header_value(self, chunk: bytes, start: int, end: int) -> None:
        self._header_value += chunk[start:end]

    def _on_header_end(self) -> None:
        self._headers[self._header_name.lower()] = self._header_value
        self._header_name = self._header_value = b""

    def _on_headers_finished(self) -> None:
        _, options = parse_options_header(self._headers.get(b"content-disposition"))
        self._name = options.get(b"name", b"").decode("utf-8", "replace")
        file_name = options.get(b"filename")
        self._file_name = None if file_name is None else file_name.decode("utf-8", "replace")
        if self._name not in self._limits:
            known = ", ".join(self._limits)
            raise InputError("field_unknown", f"unknown field {self._name[:40]!r}; known are {known}", field=self._name)
        if self._name in self.parts:
            raise InputError("field_repeated", f"the field {self._name} was sent twice; send it once", field=self._name)

    def _on_part_data(self, chunk: bytes, start: int, end: int) -> None:
        limit = self._limits[self._name]
        if len(self._content) + end - start > limit:
            raise TooLargeError("field_too_large", f"{self._name} has more than {limit} bytes", field=self._name)
        self._content += chunk[start:end]

    def _on_part_end(self) -> None:
        self.parts[self._name] = FormPart(self._name, bytes(self._content), self._file_name)

    def _on_end(self) -> None:
        self.ended = True


FIELD = "profile"


def with_reference(options: Options, part: FormPart | None, understudy: Understudy) -> Options:
    """The options with the speaker's reference that the part holds: the file of `understudy reference`, if its name
    ends in .json, else a recording of the speaker, which is heard here.

    Raises InputError `field_repeated` where the options have one already, `reference_unreadable`, and as `hear` does.
    """
    if part is None:
        return options
    if options.reference is not None:
        message = "the speaker's reference was sent in options and as a file; send only one"
        raise InputError("field_repeated", message, field="reference")
    name = part.file_name or ""
    if PurePath(name).suffix.lower() == ".json":
        return replace(options, reference=read_reference(part.content, name))
    try:
        reference = make_reference(understudy, [part.content])
    except InputError as error:
        raise type(error)(error.code, f"reference: {error.message}", field="reference") from None
    return replace(options, reference=reference)


def with_profile(options: Options, part: FormPart | None, understudy: Understudy) -> Options:
    """The options with the gesture profile that the part holds, as YAML; its name is that of the file.

    Raises InputError `field_repeated` where the options name one already, `profile_wrong`, and UndecodableError
    `text_not_utf8`.
    """
    if part is None:
        return options
    if options.profile is not None:
        message = "a profile was named in options and sent as a file; send only one"
        raise InputError("field_repeated", message, field=FIELD)
    name = PurePath(part.file_name or FIELD).stem
    try:
        profile = read_profile_text(part.text, name, understudy.behavior.characters.gesture_lexemes, load_tags())
    except AuthoringError as error:
        told = "; ".join(f"line {each.line}, column {each.column}: {each.message}" for each in error.mistakes)
        raise InputError("profile_wrong", f"{name}.yaml: {told}", field=FIELD) from None
    return replace(options, profile=profile)
