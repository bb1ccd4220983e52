"""Messages and bundles of Open Sound Control 1.0, as bytes: strings end in zeros and fill words of four bytes, numbers
are big-endian, a bundle's messages each follow their length."""

import struct
from collections.abc import Iterable, Iterator

MOST_BYTES = 1400
"""A datagram this small is not cut into pieces on its way through usual networks."""

_NOW = struct.pack(">Q", 1)
_BUNDLE = b"#bundle\0" + _NOW
_LENGTH = struct.Struct(">i")


def message(head: bytes, numbers: Iterable[float] = ()) -> bytes:
    """A message whose address, types and strings are packed already (`message_head`), with its floats."""
    values = tuple(numbers)
    return head + struct.pack(f">{len(values)}f", *values)


def message_head(address: str, types: str, *strings: str) -> bytes:
    """What comes before a message's numbers. `types` are those of all arguments, the strings (s) first."""
    return b"".join(map(_padded, (address, f",{types}", *strings)))


def bundles(messages: Iterable[bytes], most_bytes: int = MOST_BYTES) -> Iterator[bytes]:
    """As few bundles as have room for the messages in their order, none larger than `most_bytes`."""
    held = _BUNDLE
    for each in messages:
        element = _LENGTH.pack(len(each)) + each
        if len(held) + len(element) > most_bytes and held != _BUNDLE:
            yield held
            held = _BUNDLE
        held += element
    yield held


def _padded(text: str) -> bytes:
    content = text.encode("ascii") + b"\0"
    return content + b"\0" * (-len(content) % 4)
