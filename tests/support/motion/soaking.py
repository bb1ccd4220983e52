"""One recording, heard once, performed and realized by everybody in every mood: what breaks?"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from tests.support.bml.bml_checker import check
from tests.support.motion.motion_limits import broken_limits, wrist_speeds_m_s
from understudy.acoustic.stage import hear_manners
from understudy.bml.writing.writer import write_bml
from understudy.model import Agitation, Analysis, Level, Performance
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform_analysis
from understudy.realization import schedule_of
from understudy.realizer.body.contacts import penetrations_m
from understudy.realizer.realizing import realize
from understudy.rules.derivation import understand

DEEPEST_M = 0.01
"""How far a hand or forearm may be inside the body."""
FASTEST_WRIST_M_S = 3.0


@dataclass(frozen=True, slots=True)
class Variant:
    """Who performs a line, how agitated, by which luck."""

    character: str
    level: Level
    seed: int


def variants(characters: Sequence[str], seeds: int) -> Iterator[Variant]:
    """Everybody, in every mood, by so many seeds."""
    return (Variant(*each) for each in product(characters, Level, range(seeds)))


def broken_by(understudy: Understudy, analysis: Analysis, variant: Variant, *, physics: bool = False) -> list[str]:
    """What is wrong with the performance or its motion, in words."""
    performance = performed(understudy, analysis, variant)
    schedule, realizer = schedule_of(performance), understudy.realizer
    motion = realize(realizer, schedule, seed=variant.seed, physics=physics)
    skeleton = realizer.performer(schedule.character).skeleton
    deepest_m = float(np.max(penetrations_m(skeleton, motion.body.rotations, motion.body.hips_m)))
    deep = [f"a hand or forearm {100 * deepest_m:.1f} cm inside the body"] if deepest_m > DEEPEST_M else []
    fastest_m_s = float(wrist_speeds_m_s(motion, skeleton).max(initial=0.0))
    fast = [f"a wrist at {fastest_m_s:.2f} m/s"] if fastest_m_s > FASTEST_WRIST_M_S else []
    fallen = [told.reason for told in motion.decisions if "fall" in told.reason]
    return [*_broken_schedule(performance), *broken_limits(motion, skeleton), *deep, *fast, *fallen]


def performed(understudy: Understudy, analysis: Analysis, variant: Variant) -> Performance:
    """The performance of a line that was heard, as `perform` has it with the variant's agitation."""
    level = Agitation(**{name.value: float(name is variant.level) for name in Level})
    utterance = replace(analysis.utterance, agitation=level)
    if analysis.heard and utterance.affect:
        manners = hear_manners(analysis.heard, utterance.words, level, utterance.affect)
        utterance = replace(utterance, manners=manners)
    known = understand(understudy.language.rules, utterance)
    analysis = replace(analysis, utterance=utterance, functions=known.functions, facts=known.facts)
    return perform_analysis(understudy, analysis, Options(character=variant.character, seed=variant.seed))


def _broken_schedule(performance: Performance) -> Iterator[str]:
    names = {behavior.id for behavior in performance.behaviors}
    yield from (f"{each.id} lost to nobody" for each in performance.behaviors if each.lost_to not in {None, *names})
    yield from check(write_bml(performance, Options().form))
