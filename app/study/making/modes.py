"""A line in the three modes of the main paper's study (§5), which differ in their gestures alone.

Head, eyes, face and postures are those of the performance by meaning in all three. As in the paper, a head that moves
on a body whose arms move otherwise is never in quite the same place.
"""

from collections.abc import Mapping
from dataclasses import replace

from ...library.performing import perform_analysis, perform_line
from ...model import Behavior, Channel, Mode, Performance
from ...models import Understudy
from .lines import StudyLine


def in_modes(models: Understudy, study_line: StudyLine) -> Mapping[str, Performance]:
    """The line's performances by mode; raises as `perform_line` does."""
    line, options = study_line.line, study_line.options
    performed = perform_line(models, line, options)
    analysis, meant = performed.analysis, performed.performance
    others = {
        mode: perform_analysis(models, analysis, replace(options, mode=mode), line.direction)
        for mode in (Mode.PROSODY, Mode.RANDOM)
    }
    return {Mode.SEMANTIC.value: meant} | {mode.value: with_gestures_of(other, meant) for mode, other in others.items()}


def with_gestures_of(gesturing: Performance, moving: Performance) -> Performance:
    """The performance `moving` with the gestures of `gesturing`; names of behaviours are told apart by channel."""

    def is_gesture(behavior: Behavior) -> bool:
        return behavior.kind is Channel.GESTURE

    gestures = [each for each in gesturing.behaviors if is_gesture(each)]
    rest = [each for each in moving.behaviors if not is_gesture(each)]
    return replace(moving, behaviors=tuple(sorted((*gestures, *rest), key=lambda each: (each.sync.start, each.id))))
