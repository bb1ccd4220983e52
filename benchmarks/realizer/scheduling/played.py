"""Whether all scheduled gestures are played, and the speed of transitions between them.

    python -m benchmarks.realizer.scheduling.played
        [--directing FOLDER] [--lines FOLDER] [--characters NAME …] [--every]

The lines are those that directors read (../shared/directing) and the recordings of ../shared/data/speech/lines. Each is
performed with and without a lead-in, at its own agitation, by every character, and realized with two seeds; with
--every also at each agitation, at stillness .5, and in the modes prosody and random. Of the gestures that the BML has,
it counts those that the realizer plays, and what it says of the others. Transitions are those of arms, at the line's
own agitation.
"""

import argparse
import json
import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from itertools import product
from pathlib import Path

from understudy.model import Agitation, Analysis, Channel, Level, Line, Mode
from understudy.model.limits import EASY_TRANSITION_S
from understudy.models import Understudy, load_gestures
from understudy.options import Options
from understudy.performance import analyze, perform_analysis
from understudy.realization import schedule_of
from understudy.realizer.gestures.gesture_plan import GesturePlan
from understudy.realizer.scheduling.planning import plan_gestures
from understudy.realizer.scheduling.transitions import stroke_speed_m_s
from understudy.settings import Settings

SHARED = Path(__file__).resolve().parents[4] / "shared"
CHARACTERS = ("default", "expansive", "formal_elder", "reserved")
LEAD_INS_S = (0.0, 0.8)
SEEDS = (0, 1)
EQUAL = 0.02
"""Speeds that differ by no larger share are equal."""
_FRAME_S = 1 / 60
_NUMBERS = re.compile(r"gesture\d+|[\d.]*\d")


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--directing", type=Path, default=SHARED / "directing")
    arguments.add_argument("--lines", type=Path, default=SHARED / "data" / "speech" / "lines")
    arguments.add_argument("--characters", nargs="+", default=CHARACTERS)
    arguments.add_argument("--every", action="store_true")
    options = arguments.parse_args()
    with Understudy.load(Settings()) as understudy:
        analyses = [analyze(understudy, line) for line in _lines(options.directing, options.lines)]
        for character in options.characters:
            print(f"{character}, {len(analyses)} lines")
            for lead_in_s in LEAD_INS_S:
                ways = [Options(character=character, lead_in_s=lead_in_s)]
                report(f"lead-in {lead_in_s:g} s", list(_plans(understudy, analyses, ways)), transitions=True)
            if options.every:
                ways = [replace(each, character=character) for each in _every()]
                report("every level, mode and stillness", list(_plans(understudy, analyses, ways)))


def _lines(directing: Path, recordings: Path) -> Iterator[Line]:
    for line in map(json.loads, (directing / "dev-lines.jsonl").read_text(encoding="utf-8").splitlines()):
        text = " ".join(word.split(":", 1)[1] for word in line["words"])
        yield Line((directing / "audio" / f"{line['id']}.flac").read_bytes(), text)
    for path in sorted(recordings.glob("*.flac")):
        yield Line(path.read_bytes(), path.with_suffix(".txt").read_text(encoding="utf-8"))


def _every() -> Iterator[Options]:
    for level, lead_in_s in product(Level, LEAD_INS_S):
        yield Options(agitation=level, lead_in_s=lead_in_s)
        yield Options(agitation=level, lead_in_s=lead_in_s, stillness=0.5)
        yield Options(agitation=level, lead_in_s=lead_in_s, mode=Mode.PROSODY)
        yield Options(agitation=level, lead_in_s=lead_in_s, mode=Mode.RANDOM)


def _plans(understudy: Understudy, analyses: list[Analysis], ways: list[Options]) -> Iterator[tuple[int, GesturePlan]]:
    """How many gestures a performance has, and their plan."""
    for analysis, options in product(analyses, ways):
        manner = understudy.behavior.characters.named(options.character).figure.manner
        library = load_gestures().in_manner(manner)
        schedule = schedule_of(perform_analysis(understudy, _at_level(analysis, options.agitation), options))
        asked = sum(each.kind is Channel.GESTURE for each in schedule.behaviors)
        for seed in SEEDS:
            yield asked, plan_gestures(library, schedule, seed=seed)


def _at_level(analysis: Analysis, level: Level | None) -> Analysis:
    if level is None:
        return analysis
    agitation = Agitation(**{name.value: float(name is level) for name in Level})
    return replace(analysis, utterance=replace(analysis.utterance, agitation=agitation))


def report(title: str, planned: list[tuple[int, GesturePlan]], *, transitions: bool = False) -> None:
    asked, plans = sum(count for count, _plan in planned), [plan for _count, plan in planned]
    played = sum(len(plan.realized) for plan in plans)
    print(f"  {title}: {played} of {asked} gestures played, {played / max(asked, 1):.4f}")
    told = Counter(
        f"{each.action}: {_NUMBERS.sub('#', each.reason)}"
        for plan in plans
        for each in plan.decisions
        if each.action in ("dropped", "replaced", "late")
    )
    for reason, count in told.most_common(8):
        print(f"    {count} {reason}")
    if transitions:
        report_transitions(plans)


def report_transitions(plans: list[GesturePlan]) -> None:
    """The transitions of arms by how their speed compares with that of the next stroke, and why they differ."""
    counts = Counter(kind for plan in plans for kind in _kinds(plan))
    shares = ", ".join(f"{kind} {100 * count / counts.total():.0f} %" for kind, count in counts.most_common())
    print(f"    {counts.total()} transitions: {shares}")


def _kinds(plan: GesturePlan) -> Iterator[str]:
    arms = {(arm.behavior, arm.side): arm for arm in plan.gestures}
    for each in plan.transitions:
        first, second = arms[each.first, each.side], arms[each.second, each.side]
        ratio = each.speed_m_s / stroke_speed_m_s(second.placed)
        if abs(ratio - 1) <= EQUAL:
            yield "as fast as the stroke"
        elif ratio < 1:
            shortest = each.end_s - each.start_s <= EASY_TRANSITION_S + _FRAME_S
            yield f"slower, for none is shorter than {EASY_TRANSITION_S:g} s" if shortest else "slower for no reason"
        elif first.markers.relax - first.markers.stroke_end < _FRAME_S:
            yield "faster, with no hold to shorten"
        else:
            yield "faster, with a short hold left"


if __name__ == "__main__":
    main()
