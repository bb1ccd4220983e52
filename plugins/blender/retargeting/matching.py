"""Finds our joints among the bones of an armature, by the names that families of rigs give them.

Names are compared without prefix (`mixamorig:`, `mixamorig2:`, `Armature|`), case, blanks and separators, so that
`LeftHandThumb1`, `mixamorig:LeftHandThumb1` and `left_hand_thumb1` are one.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain

from .bone_tables import BoneTable
from .skeleton import NEEDED

_PREFIX = re.compile(r"^.*[:|]|^mixamorig\d*[_ ]?", re.IGNORECASE)
_SEPARATORS = re.compile(r"[\s_.\-]+")


@dataclass(frozen=True, slots=True)
class BoneMap:
    """Bones by our joints, and the table that named them."""

    table: BoneTable
    bones: Mapping[str, str]

    @property
    def missing(self) -> tuple[str, ...]:
        """Joints without which nothing can be performed."""
        return tuple(joint for joint in NEEDED if joint not in self.bones)


def find_bones(bones: Iterable[str], tables: Sequence[BoneTable]) -> BoneMap:
    """The bones by the table that finds most joints, the first of equals; those of the best may still be too few."""
    names = list(bones)
    exact = {name: name for name in names}
    plain: dict[str, str] = {}
    for name in names:
        plain.setdefault(plain_name(name), name)
    found = [BoneMap(table, _found(table, exact, plain)) for table in tables]
    return max(found, key=lambda each: (not each.missing, len(each.bones)))


def plain_name(name: str) -> str:
    """A name as it is compared."""
    return _SEPARATORS.sub("", _PREFIX.sub("", name)).lower()


def _found(table: BoneTable, exact: Mapping[str, str], plain: Mapping[str, str]) -> dict[str, str]:
    """Each bone for one joint only: that which comes first in the table."""
    found: dict[str, str] = {}
    for joint, names in table.names.items():
        candidates = chain((exact.get(name) for name in names), (plain.get(plain_name(name)) for name in names))
        bone = next((each for each in candidates if each and each not in found.values()), None)
        if bone:
            found[joint] = bone
    return found
