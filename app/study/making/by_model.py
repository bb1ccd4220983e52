"""A line's motions by a motion model: in the thesis' three ways from a voice to motion (RTS §3.2), or driven by voice
and affect, the voice alone, affect alone (AHG §3), of which AHG §5 announces a test by raters; and by the profiles of
speakers (NGS §3.5).

Head, eyes, face and legs are the same in all of a line's motions, but for what the model has learnt.
"""

from collections.abc import Mapping
from dataclasses import replace

from ...library.motion import PreparedSchedule, RealizedSchedule
from ...library.motion_models import (
    MotionModel,
    moving_by,
    realize_moving,
    realize_played,
    scenario_named,
)
from ...library.performing import perform_line
from ...models import Understudy
from ...profiles.profile import Profile
from ..comparison import AFFECT, BOTH, LIVE, OFFLINE, PROSODY, RANDOM
from .lines import StudyLine
from .site import FRAME_RATE_HZ, TAIL_S, realized

WHOLE = "RTS"
DRIVEN_BY: Mapping[str, str] = {BOTH: "S1", PROSODY: "S3", AFFECT: "S5"}
"""The scenarios of AHG Table 1 whose units are chosen by affect too."""


def in_ways(models: Understudy, model: MotionModel, line: StudyLine, seed: int) -> Mapping[str, RealizedSchedule]:
    """The line for the whole recording, as it is played live, and by units drawn at random; raises as `perform_line`
    does."""
    performed = perform_line(models, line.line, line.options)
    prepared, analysis, realizer = PreparedSchedule.of(performed.performance), performed.analysis, models.realizer
    moving = moving_by(model, analysis, None, scenario_named(WHOLE))
    return {
        OFFLINE: realize_moving(realizer, prepared, moving, frame_rate_hz=FRAME_RATE_HZ, tail_s=TAIL_S),
        LIVE: realize_played(realizer, prepared, model, analysis, frame_rate_hz=FRAME_RATE_HZ, tail_s=TAIL_S),
        RANDOM: realize_played(
            realizer, prepared, model, analysis, drawn_by=seed, frame_rate_hz=FRAME_RATE_HZ, tail_s=TAIL_S
        ),
    }


def driven_by_affect(models: Understudy, model: MotionModel, line: StudyLine) -> Mapping[str, RealizedSchedule]:
    """The line driven by voice and affect, by one, by the other; raises as `perform_line` does."""
    performed = perform_line(models, line.line, line.options)
    prepared, analysis = PreparedSchedule.of(performed.performance), performed.analysis
    return {
        name: realize_moving(
            models.realizer,
            prepared,
            moving_by(model, analysis, line.options.affect, scenario_named(scenario)),
            frame_rate_hz=FRAME_RATE_HZ,
            tail_s=TAIL_S,
        )
        for name, scenario in DRIVEN_BY.items()
    }


def by_speakers(
    models: Understudy, speakers: Mapping[str, Profile | str], line: StudyLine
) -> Mapping[str, RealizedSchedule]:
    """The line with the gestures of each speaker; raises as `perform_line` does."""
    performances = {
        name: perform_line(models, line.line, replace(line.options, profile=profile)).performance
        for name, profile in speakers.items()
    }
    return {name: realized(models, PreparedSchedule.of(each)) for name, each in performances.items()}
