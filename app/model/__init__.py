"""The values that pass between the stages of a performance, from the audio to the schedule.

Conventions: times are seconds from the start of the audio. Words are what white space separates in the transcript,
numbered from 0; `first` and `last` are word numbers, both included. Everything here is frozen: a stage that changes a
value returns a changed copy (`dataclasses.replace`).

`signal`, `speech` and `affect` have the results of acoustic analysis, `language` and `functions` those of understanding
the words, `choice` the plan and the candidates, `body` and `schedule` the behaviours, `performance` all of it, and
`line` the input with a director's notes. Import the values from here. A module is imported with the first of its values
that is used, so that what needs no sound does without NumPy.
"""

from typing import TYPE_CHECKING

from ..lazy_names import imported_on_first_use

__all__ = [
    "DEFAULT_CHARACTER",
    "EMPHASISED",
    "FRAME_SHIFT_S",
    "NEUTRAL",
    "PLAIN",
    "PLAINLY_SPOKEN",
    "SAMPLE_RATE_HZ",
    "Affect",
    "AffectTrack",
    "Agitation",
    "AlignedLine",
    "Alternative",
    "Analysis",
    "Argument",
    "Audio",
    "Avoidance",
    "Because",
    "Behavior",
    "BehaviorCandidates",
    "CallableNames",
    "Channel",
    "Clause",
    "Contours",
    "Demand",
    "DirectedMoment",
    "Direction",
    "Distance",
    "Fact",
    "Filler",
    "FloatArray",
    "Function",
    "GivenFunction",
    "Hand",
    "Height",
    "Interval",
    "Level",
    "Limit",
    "Line",
    "LineAffect",
    "Listening",
    "Manner",
    "MappedFunctions",
    "Mode",
    "Moment",
    "Movement",
    "Notice",
    "Parse",
    "Performance",
    "Phone",
    "Phrase",
    "PhraseAffect",
    "RejectedAlternative",
    "Schedule",
    "Side",
    "SignalAnalysis",
    "SingleArray",
    "Size",
    "Slots",
    "Speaking",
    "StressThresholds",
    "SyncPoints",
    "Target",
    "Term",
    "Timings",
    "Token",
    "Tone",
    "Utterance",
    "Viseme",
    "VoiceQuality",
    "Which",
    "Word",
    "mean_affect",
]

if TYPE_CHECKING:
    from .body import Channel, Hand
    from .choice import (
        Alternative,
        BehaviorCandidates,
        CallableNames,
        Demand,
        MappedFunctions,
        Mode,
        Moment,
        Movement,
        RejectedAlternative,
    )
    from .functions import PLAIN, Argument, Because, Fact, Function, GivenFunction, Term
    from .language import Clause, Parse, Phrase, Token, Utterance
    from .line import AlignedLine, Analysis, Avoidance, DirectedMoment, Direction, Line, SignalAnalysis, Timings
    from .performance import Notice, Performance
    from .schedule import DEFAULT_CHARACTER, Behavior, Limit, Listening, Schedule, SyncPoints, Target, Viseme
    from .slots import Distance, Height, Side, Size, Slots, Which
    from .voice.affect import NEUTRAL, Affect, AffectTrack, LineAffect, Manner, PhraseAffect, Tone, mean_affect
    from .voice.signal import (
        FRAME_SHIFT_S,
        PLAINLY_SPOKEN,
        SAMPLE_RATE_HZ,
        Audio,
        Contours,
        FloatArray,
        SingleArray,
        Speaking,
        VoiceQuality,
    )
    from .voice.speech import EMPHASISED, Agitation, Filler, Interval, Level, Phone, StressThresholds, Word
else:
    _HOMES = (
        "body",
        "slots",
        "functions",
        "voice.speech",
        "voice.affect",
        "choice",
        "schedule",
        "language",
        "performance",
        "voice.signal",
        "line",
    )
    __getattr__ = imported_on_first_use(__name__, frozenset(__all__), _HOMES)
