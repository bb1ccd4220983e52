"""Writes small ONNX files without the library `onnx`: the wire format of protocol buffers, with the field numbers of
onnx.proto."""

import struct
from collections.abc import Mapping, Sequence

FLOAT = 1
_INTEGERS = 7
"""The types of a tensor and of an attribute."""

Message = Sequence[tuple[int, "int | str | bytes"]]


def message(*fields: tuple[int, int | str | bytes]) -> bytes:
    """A message of these numbered fields: numbers as variable-length integers, all else with its length."""
    return b"".join(_field(number, value) for number, value in fields)


def _field(number: int, value: int | str | bytes) -> bytes:
    if isinstance(value, int):
        return _varint(number << 3) + _varint(value)
    content = value.encode() if isinstance(value, str) else value
    return _varint(number << 3 | 2) + _varint(len(content)) + content


def _varint(value: int) -> bytes:
    *rest, last = [value >> shift & 0x7F for shift in range(0, max(value.bit_length(), 1), 7)]
    return bytes([*(each | 0x80 for each in rest), last])


def constant_plus_mean(
    outputs: Mapping[str, Sequence[float]], shape: Sequence[str | int], metadata: Mapping[str, str]
) -> bytes:
    """A model whose input `wave` has this shape and whose outputs are these numbers plus the mean of the input."""
    axes = [(5, message((1, "axes"), *((8, axis) for axis in range(len(shape))), (20, _INTEGERS)))]
    keep = [(5, message((1, "keepdims"), (3, 0), (20, 2)))]
    nodes = [(1, message((1, "wave"), (2, "mean"), (4, "ReduceMean"), *axes, *keep))]
    nodes += [(1, message((1, f"{name}_of"), (1, "mean"), (2, name), (4, "Add"))) for name in outputs]
    constants = [(5, _tensor(f"{name}_of", numbers)) for name, numbers in outputs.items()]
    told = [(12, _value(name, [1, len(numbers)])) for name, numbers in outputs.items()]
    graph = message(*nodes, (2, "affect"), *constants, (11, _value("wave", shape)), *told)
    properties = [(14, message((1, key), (2, value))) for key, value in metadata.items()]
    return message((1, 8), (8, message((1, ""), (2, 13))), (7, graph), *properties)


def _tensor(name: str, numbers: Sequence[float]) -> bytes:
    raw = struct.pack(f"<{len(numbers)}f", *numbers)
    return message((1, 1), (1, len(numbers)), (2, FLOAT), (8, name), (9, raw))


def _value(name: str, shape: Sequence[str | int]) -> bytes:
    axes = [(1, message((1, axis) if isinstance(axis, int) else (2, axis))) for axis in shape]
    return message((1, name), (2, message((1, message((1, FLOAT), (2, message(*axes)))))))
