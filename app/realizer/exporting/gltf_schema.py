"""What is read of an avatar's JSON tree (glTF 2.0 §5; VRM 1.0 and VRM 0's bone tables), and what it may contain.

Numbers of nodes, meshes, views are whole and not negative; that they exist is checked with the tree (`avatar_reading`).
All that is not read here may be anything and is passed on as it is.
"""

from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, Strict, ValidationError

LARGEST = 1e6
"""No coordinate, and no scale, of a usable avatar is larger."""

_LONGEST_KEY = 40

Number = Annotated[float, Strict(), Field(ge=-LARGEST, le=LARGEST, allow_inf_nan=False)]
Index = Annotated[int, Strict(), Field(ge=0, lt=2**31)]


class _Part(BaseModel):
    model_config = ConfigDict(frozen=True, defer_build=True)


class Node(_Part):
    """A node with its transform: `matrix`, by columns, or the three others."""

    name: str = ""
    children: tuple[Index, ...] = ()
    mesh: Index | None = None
    matrix: Annotated[tuple[Number, ...], Field(min_length=16, max_length=16)] | None = None
    translation: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)
    rotation: tuple[Number, Number, Number, Number] = (0.0, 0.0, 0.0, 1.0)
    scale: tuple[Number, Number, Number] = (1.0, 1.0, 1.0)


class Primitive(_Part):
    """A part of a mesh, with its morph targets."""

    targets: tuple[Any, ...] = ()
    extras: Any = None


class Mesh(_Part):
    """Exporters write the names of morph targets into the `extras` of the mesh, or of its first primitive."""

    primitives: Annotated[tuple[Primitive, ...], Field(min_length=1)]
    extras: Any = None

    def target_names(self) -> list[str]:
        """The names of its morph targets; none if there is not one for each."""
        count = len(self.primitives[0].targets)
        for extras in (self.extras, self.primitives[0].extras):
            names = extras.get("targetNames") if isinstance(extras, dict) else None
            if isinstance(names, list) and len(names) == count:
                return [str(name) for name in names]
        return []


class Buffer(_Part):
    """The data in the file itself; a buffer elsewhere has a `uri`."""

    byte_length: Annotated[Index, Field(alias="byteLength")]
    uri: None = None


class View(_Part):
    """A part of the buffer."""

    buffer: Annotated[int, Strict(), Field(ge=0, le=0)]
    byte_offset: Annotated[Index, Field(alias="byteOffset")] = 0
    byte_length: Annotated[Index, Field(alias="byteLength")]


class Accessor(_Part):
    """An array in a view, or in none where it is all zeros or sparse."""

    view: Annotated[Index | None, Field(alias="bufferView")] = None


class VrmBone(_Part):
    node: Index


class NamedBone(VrmBone):
    bone: str


class Humanoid1(_Part):
    human_bones: Annotated[dict[str, VrmBone], Field(alias="humanBones")]


class Vrm1(_Part):
    humanoid: Humanoid1


class Humanoid0(_Part):
    human_bones: Annotated[tuple[NamedBone, ...], Field(alias="humanBones")] = ()


class Vrm0(_Part):
    humanoid: Humanoid0 = Humanoid0()


class Extensions(_Part):
    vrm1: Annotated[Vrm1 | None, Field(alias="VRMC_vrm")] = None
    vrm0: Annotated[Vrm0 | None, Field(alias="VRM")] = None


class AvatarFile(_Part):
    """The file's JSON tree."""

    asset: dict[str, Any] = {}
    nodes: Annotated[tuple[Node, ...], Field(min_length=1)]
    meshes: tuple[Mesh, ...] = ()
    buffers: Annotated[tuple[Buffer, ...], Field(min_length=1, max_length=1)]
    views: Annotated[tuple[View, ...], Field(alias="bufferViews")] = ()
    accessors: tuple[Accessor, ...] = ()
    extensions: Extensions = Extensions()

    @classmethod
    def of(cls, tree: object) -> "AvatarFile":
        """Raises ValueError that says what is wrong, and where."""
        try:
            return cls.model_validate(tree)
        except ValidationError as error:
            found = error.errors()[0]
        where = ".".join(str(step)[:_LONGEST_KEY] for step in found["loc"])
        told = f"{where or 'it'}: {found['msg'][0].lower()}{found['msg'][1:]}"
        raise ValueError(told.encode(errors="backslashreplace").decode())
