"""Agreement with directors on held-out lines of each kind, by the words alone.

    python -m benchmarks.behavior.kinds [--directing FOLDER] [--written 3] [--reader MODEL.onnx --of KIND …]
        [--twice | --with-care | --read-alone] [--record]

Performs the carefully directed lines that no reader was trained on (`training.acting.directed.is_held_out`; their kinds
were), each word with a usual duration, and scores them with score.py of the folder against the one reading that each
has. With `--written` they are all lines of that series of our own (`training/acting/lines/KIND_3.jsonl`), held out or
not: those that were written after a `--reader` was trained are as new to it. With `--of` they are every sixth line of
these kinds, or with both all lines of these kinds in that series; `--reader` is a reader that was trained without them.
With `--twice` only lines with a second reading count, and both readings do: what both name is asked for, what either
names is right. With `--with-care` the lines that three directors read with care (`training/acting/lines/careful`) are
scored against these alone, as the 78 lines are. With `--read-alone` the heads and faces of these lines are scored
against three readings of head or face alone (`training/acting/channel_readings.py`), whose readers name as few as the
directors of the 78 lines do; their hands are not.
"""

import argparse
import json
import re
import zlib
from collections import Counter, defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from statistics import mean
from typing import Any, TypeAlias

from benchmarks.behavior.agreement import Bars, agreement, record_all
from benchmarks.behavior.directing import gestures_of, load_score, others_of
from benchmarks.figures import add_record_option
from training.acting.channel_readings import as_moments, channel_readings
from training.acting.directed import DirectedLine, is_held_out, read_lines
from training.acting.held_out import timed
from training.acting.second_readings import DIRECTORS, readings_by_three, second_readings
from understudy.behavior.reading.encoder import Encoder
from understudy.library.language import find_functions
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform_analysis
from understudy.settings import Settings

DRAWN_EVERY = 6

BARS: Bars = {"F": ("≥ 0.52", "≥ 0.60"), "head done": (None, None), "face done": (None, None)}
READ_ALONE: Bars = dict.fromkeys(("head done", "face done", "tones right"), (None, None))


Readings: TypeAlias = Mapping[tuple[str, tuple[str, ...]], Sequence[DirectedLine]]
"""The readings of lines by kind and words."""


def readings_once(directing: Path, among: Callable[[DirectedLine], bool]) -> Readings:
    """The first readings of the lines `among` which they are."""
    found: dict[tuple[str, tuple[str, ...]], list[DirectedLine]] = defaultdict(list)
    for line in read_lines(directing):
        if not line.is_delivery and among(line):
            found[line.source, line.words].append(line)
    return found


def with_second(readings: Readings) -> Readings:
    """The lines that were read twice, with their second readings."""
    second = second_readings()
    return {
        line: [*firsts, *(replace(each, reading=second[each.name]) for each in firsts if each.name in second)]
        for line, firsts in readings.items()
        if any(each.name in second for each in firsts)
    }


def read_with_care(readings: Readings) -> Readings:
    """The lines that three directors read with care, with these readings."""
    careful = readings_by_three()
    return {
        line: [replace(first, reading=each) for each in careful[first.name]]
        for line, (first, *_others) in readings.items()
        if first.name in careful
    }


def read_alone(readings: Readings) -> Readings:
    """The lines whose head and face three readers read alone, with these readings."""
    heads, faces = channel_readings("head"), channel_readings("face")
    return {
        line: [
            replace(
                first, reading={"moments": as_moments(head, "head")["moments"] + as_moments(face, "face")["moments"]}
            )
            for head, face in zip(heads[first.name], faces[first.name], strict=True)
        ]
        for line, (first, *_others) in readings.items()
        if min(len(heads.get(first.name, ())), len(faces.get(first.name, ()))) == DIRECTORS
    }


def measure(directing: Path, readings: Readings, reader: Path | None) -> dict[str, float]:
    """Performs and scores lines, and prints the agreement by kind; returns that of all."""
    totals: dict[str, Counter[str]] = defaultdict(Counter)
    counts: Counter[str] = Counter()
    with Understudy.load(Settings()) as loaded:
        understudy = _with_reader(loaded, reader) if reader else loaded
        score = load_score(directing, understudy.behavior.families.shows)
        for (kind, words), lines in readings.items():
            performance = perform_analysis(understudy, timed(find_functions(understudy, " ".join(words))), Options())
            records = records_of(score, lines)
            judged = score.judge(records, gestures_of(score, performance))
            judged += score.other_channels(records, *others_of(score, performance))
            for name in ("all", kind):
                totals[name] += judged
                counts[name] += 1
    shown = {name: score.show(f"{name}, {counts[name]} lines", total, counts[name]) for name, total in totals.items()}
    kinds = [value for name, value in shown.items() if name != "all"]
    print(f"mean of {len(kinds)} kinds: F {mean(kinds):.3f}")
    return agreement(score, totals["all"], counts["all"])


def _with_reader(understudy: Understudy, reader: Path) -> Understudy:
    models = understudy.behavior
    planner = replace(models.planner, encoder=Encoder.load(reader))
    return replace(understudy, behavior=replace(models, planner=planner))


def _is_of(line: DirectedLine, series: str, kinds: Sequence[str]) -> bool:
    of_series = re.fullmatch(rf"[a-z]+{re.escape(series)}-\d+", line.name) is not None
    return of_series and (not kinds or line.source in kinds)


def _is_drawn(line: DirectedLine, kinds: Sequence[str]) -> bool:
    return line.source in kinds and zlib.crc32(line.name.encode()) % DRAWN_EVERY == 0


def records_of(score: Any, lines: Sequence[DirectedLine]) -> list[dict[str, Any]]:  # noqa: ANN401
    """The readings of a line as score.py reads them: pointings are one family."""
    records = json.loads(json.dumps([line.reading for line in lines]))
    for record in records:
        for moment in record["moments"]:
            moment["gesture"] = list(dict.fromkeys(score.SAME.get(each, each) for each in moment.get("gesture") or ()))
        for each in record.get("avoid", ()):
            each["what"] = [score.SAME.get(what, what) for what in each["what"]]
    return list(records)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    parser.add_argument("--written", default="", help="the number of a series of our own lines")
    parser.add_argument("--of", nargs="+", default=[], help="kinds of lines")
    parser.add_argument("--reader", type=Path, help="a reader in place of the shipped one")
    against = parser.add_mutually_exclusive_group()
    against.add_argument("--twice", action="store_true", help="score against two readings")
    against.add_argument("--with-care", action="store_true", help="score against three careful readings")
    against.add_argument("--read-alone", action="store_true", help="score heads and faces against those who name few")
    add_record_option(parser)
    options = parser.parse_args()
    among: Callable[[DirectedLine], bool] = is_held_out
    if options.written:
        among = partial(_is_of, series=options.written, kinds=options.of)
    elif options.of:
        among = partial(_is_drawn, kinds=options.of)
    readings = readings_once(options.directing, among)
    read = "one reading"
    if options.twice:
        readings, read = with_second(readings), "two readings"
    elif options.with_care:
        readings, read = read_with_care(readings), "three careful readings"
    elif options.read_alone:
        readings, read = read_alone(readings), "head and face read alone"
    figures = measure(options.directing, readings, options.reader)
    if options.record and among is is_held_out:
        record_all(f"held-out lines of known kinds, {read}", figures, READ_ALONE if options.read_alone else BARS)


if __name__ == "__main__":
    main()
