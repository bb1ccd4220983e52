"""Reads binary glTF by the specification alone, for the tests of what we write."""

import json
import struct
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

_TYPES = {5121: "<u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


@dataclass(frozen=True)
class Gltf:
    """The JSON tree and the buffer of a file."""

    tree: dict[str, Any]
    buffer: bytes

    def values(self, number: int) -> NDArray[Any]:
        """An accessor's values (N, width), sparse ones filled in."""
        accessor = self.tree["accessors"][number]
        width, kind = _WIDTHS[accessor["type"]], _TYPES[accessor["componentType"]]
        found = np.zeros((accessor["count"], width), kind)
        if "bufferView" in accessor:
            found = self._view(accessor["bufferView"], kind).reshape(-1, width)
        if "sparse" in accessor:
            sparse = accessor["sparse"]
            where = self._view(sparse["indices"]["bufferView"], _TYPES[sparse["indices"]["componentType"]])
            found[where] = self._view(sparse["values"]["bufferView"], kind).reshape(-1, width)
        assert len(found) == accessor["count"]
        return found

    def node(self, name: str) -> int:
        """The number of the node of this name."""
        return [node.get("name") for node in self.tree["nodes"]].index(name)

    def track(self, node: str, path: str) -> tuple[NDArray[Any], NDArray[Any]]:
        """The keys' times (K,) and values (K, width) of a channel of the first animation."""
        animation = self.tree["animations"][0]
        target = {"node": self.node(node), "path": path}
        channel = next(each for each in animation["channels"] if each["target"] == target)
        sampler = animation["samplers"][channel["sampler"]]
        assert sampler["interpolation"] == "LINEAR"
        times_s = self.values(sampler["input"])[:, 0]
        return times_s, self.values(sampler["output"]).reshape(len(times_s), -1)

    def _view(self, number: int, kind: str) -> NDArray[Any]:
        view = self.tree["bufferViews"][number]
        start = view.get("byteOffset", 0)
        return np.frombuffer(self.buffer[start : start + view["byteLength"]], kind)


def read(content: bytes) -> Gltf:
    """Checks the header and both chunks."""
    magic, version, length, json_length, json_kind = struct.unpack_from("<4sIII4s", content)
    assert (magic, version, length, json_kind) == (b"glTF", 2, len(content), b"JSON")
    assert json_length % 4 == 0
    binary = 20 + json_length
    binary_length, binary_kind = struct.unpack_from("<I4s", content, binary)
    assert binary_kind == b"BIN\0"
    assert binary + 8 + binary_length == len(content)
    return Gltf(json.loads(content[20:binary]), content[binary + 8 :])
