"""Reads MPEG-4 body and face parameters as motion, so that what was written, here or elsewhere, can be seen."""

from types import MappingProxyType

from ..authored_folders import lexicon_folder
from ..errors import InputError
from ..model import Schedule
from ..realizer.body.motion import Motion
from ..realizer.mpeg4.bap_reading import from_bap
from ..realizer.mpeg4.fap import TABLE, FapTable, from_fap, named_shapes
from ..realizer.mpeg4.layout import BAPS, FAPS, ReadParameters, read_parameter_file
from ..realizer.realizing import Realizer
from .motion import RealizedSchedule


def read_mpeg4(
    body: tuple[str, bytes] | None, face: tuple[str, bytes] | None, realizer: Realizer, character: str
) -> RealizedSchedule:
    """The motion of a body's file, a face's, or both, each its name and content, on a character's body; one that has no
    file stands in the T-pose.

    Raises InputError `mpeg4_wrong` for a file that cannot be read, or two that do not go together.
    """
    skeleton = realizer.performer(character).skeleton
    bap = read_parameter_file(body[1], BAPS, body[0]) if body else None
    fap = read_parameter_file(face[1], FAPS, face[0]) if face else ReadParameters("", 0.0, 0, {})
    if bap is not None and face is not None and (bap.frames, bap.rate_hz) != (fap.frames, fap.rate_hz):
        told = [f"{each.frames} frames at {each.rate_hz:g} a second" for each in (bap, fap)]
        raise InputError("mpeg4_wrong", f"body and face do not match: {' and '.join(told)}", field="bml")
    moved = from_bap(bap, skeleton) if bap else None
    if bap is not None and face is None:
        fap = ReadParameters(bap.version, bap.rate_hz, bap.frames, {})
    table = FapTable.load(lexicon_folder() / TABLE)
    moved, shapes = from_fap(fap, skeleton, table, moved)
    if not fap.numbers.keys() & table.amounts.keys():
        shapes = named_shapes(fap, realizer.face.visemes.targets)
    motion = Motion(max(1, round(fap.rate_hz)), moved, shapes, MappingProxyType({}))
    return RealizedSchedule(Schedule((), fap.frames / fap.rate_hz, character=character), motion)
