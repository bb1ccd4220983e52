"""From a schedule to motion and its files: from a performance, or from any BML file.

`bml` turns a BML file into a schedule, `motion` realizes schedules, `writing` writes the files.
"""

from ..model.formats import FileOptions, Keys, MotionFormat, format_of
from ..realizer.realizing import Realizer, realize
from .bml import BmlInput, prepare_schedule
from .motion import PreparedSchedule, RealizedSchedule, realize_prepared, schedule_of
from .writing import OURS, AvatarOptions, write_motion

__all__ = [
    "OURS",
    "AvatarOptions",
    "BmlInput",
    "FileOptions",
    "Keys",
    "MotionFormat",
    "PreparedSchedule",
    "RealizedSchedule",
    "Realizer",
    "format_of",
    "prepare_schedule",
    "realize",
    "realize_prepared",
    "schedule_of",
    "write_motion",
]
