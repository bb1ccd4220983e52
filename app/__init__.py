"""Understudy performs a spoken line in an actor's stead: audio and words in, a schedule of movements out.

    import understudy

    with understudy.load() as models:
        performance = understudy.perform(models, "line.wav", "No, I have never seen those.", seed=1)
        bml = understudy.write_bml(performance)
        glb = understudy.write_motion(models, understudy.realize(models, performance), "glb")

This module is the whole public interface: the functions of `understudy.library`, the values that they take and return,
and the errors that they raise. Names are imported on first use, so that `import understudy` is cheap. docs/python.md
has examples. To read the code, begin with `understudy.performance`, which runs the stages of a line in order, and
`understudy.model`, the values that pass between them.
"""

from typing import TYPE_CHECKING

from .lazy_names import imported_on_first_use
from .version import __version__

__all__ = [
    "AcousticModels",
    "Agitation",
    "AlignedLine",
    "Analysis",
    "AuthoringError",
    "Avoidance",
    "Because",
    "Behavior",
    "Channel",
    "Clause",
    "DialectName",
    "DirectedMoment",
    "Direction",
    "Filler",
    "Function",
    "GivenFunction",
    "Hand",
    "InputError",
    "Interval",
    "LanguageModels",
    "Level",
    "Listening",
    "Mistake",
    "Mode",
    "Motion",
    "MotionFormat",
    "Notice",
    "Parse",
    "Performance",
    "Phone",
    "Phrase",
    "RealizedSchedule",
    "Realizer",
    "Schedule",
    "ServiceError",
    "Settings",
    "SpeakerReference",
    "StressThresholds",
    "SyncPoints",
    "TimeForm",
    "Timings",
    "Token",
    "TooLargeError",
    "UndecodableError",
    "Understudy",
    "UnderstudyError",
    "UnsupportedFormatError",
    "Utterance",
    "Viseme",
    "Word",
    "WrongBmlError",
    "__version__",
    "align",
    "analyze",
    "find_functions",
    "load",
    "make_reference",
    "perform",
    "realize",
    "realize_bml",
    "realize_by_model",
    "say",
    "write_bml",
    "write_bml_json",
    "write_ctm",
    "write_json",
    "write_motion",
    "write_speech_file",
    "write_textgrid",
]

if TYPE_CHECKING:
    from .errors import (
        AuthoringError,
        InputError,
        Mistake,
        ServiceError,
        TooLargeError,
        UndecodableError,
        UnderstudyError,
        UnsupportedFormatError,
        WrongBmlError,
    )
    from .library.hearing import AcousticModels, align, make_reference
    from .library.language import find_functions
    from .library.motion import MotionFormat, RealizedSchedule, Realizer, realize, realize_bml, write_motion
    from .library.motion_models import realize_by_model
    from .library.performing import analyze, load, perform, say
    from .library.writing import (
        write_bml,
        write_bml_json,
        write_ctm,
        write_json,
        write_speech_file,
        write_textgrid,
    )
    from .model import (
        Agitation,
        AlignedLine,
        Analysis,
        Avoidance,
        Because,
        Behavior,
        Channel,
        Clause,
        DirectedMoment,
        Direction,
        Filler,
        Function,
        GivenFunction,
        Hand,
        Interval,
        Level,
        Listening,
        Mode,
        Notice,
        Parse,
        Performance,
        Phone,
        Phrase,
        Schedule,
        StressThresholds,
        SyncPoints,
        Timings,
        Token,
        Utterance,
        Viseme,
        Word,
    )
    from .model.formats import DialectName, TimeForm
    from .model.voice.signal import SpeakerReference
    from .models import LanguageModels, Understudy
    from .realizer.body.motion import Motion
    from .settings import Settings
else:
    _HOMES = (
        "errors",
        "model",
        "model.formats",
        "model.voice.signal",
        "models",
        "settings",
        "library.language",
        "library.hearing",
        "library.writing",
        "library.performing",
        "library.motion",
        "library.motion_models",
        "realizer.body.motion",
    )
    __getattr__ = imported_on_first_use(__name__, frozenset(__all__), _HOMES)

    def __dir__() -> list[str]:
        return sorted({*globals(), *__all__})
