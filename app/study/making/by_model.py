"""A line's motions in three comparisons.

- ways: a motion model driven in the three ways of the thesis (RTS §3.2);
- affect: a motion model driven by voice and affect, by the voice alone, or by affect alone (AHG §3; AHG §5 announces a
  test by raters);
- speakers: gestures by the profiles of speakers (NGS §3.5).

Head, eyes, face and legs are the same in all motions of a line, except for those parts that the model has learnt.
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
"""The scenario of AHG Table 1 for each condition of `Comparison.AFFECT`."""


def in_ways(models: Understudy, model: MotionModel, line: StudyLine, seed: int) -> Mapping[str, RealizedSchedule]:
    """The line's motion for the complete recording, for a live one, and with units drawn at random; raises as
    `perform_line` does."""
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
    """The line's motion driven by voice and affect, by the voice alone, and by affect alone; raises as `perform_line`
    does."""
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
    """The line's motion with the gestures of each speaker; raises as `perform_line` does."""
    performances = {
        name: perform_line(models, line.line, replace(line.options, profile=profile)).performance
        for name, profile in speakers.items()
    }
    return {name: realized(models, PreparedSchedule.of(each)) for name, each in performances.items()}
