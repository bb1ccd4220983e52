"""How far a performance follows the delivery: the same words said differently, each directed on its own.

    python -m benchmarks.behavior.deliveries [--directing FOLDER] [--choice terms|priority] [--as-written]
        [--seed N] [--record]

Performs the recorded deliveries of the folder `deliveries` and prints the figures of its deliveries.py: agreement with
the directors, deliveries told apart, strokes on the focus. With --as-written the performance is told the focus, tone
and loudness that the speaker was given, instead of what is heard in the recording: what would be possible with a
perfect ear.
"""

import argparse
import importlib.util
import json
import os
import sys
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

from benchmarks.behavior.agreement import Bars, agreement, record_all
from benchmarks.behavior.directing import gestures_of, load_score, others_of
from benchmarks.figures import add_record_option
from training.acting.listening import TONES
from understudy.model import Affect, Agitation, Line, LineAffect, Tone, Utterance
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import analyze, perform_analysis
from understudy.settings import Settings

BARS: Bars = {
    "F": ("≥ 0.52", "≥ 0.65"),
    "accepted F": (None, None),
    "forbidden": (None, None),
    "head done": ("≥ 0.50", "≥ 0.7"),
    "face done": ("≥ 0.50", "≥ 0.7"),
    "told apart": ("≥ 0.80", "≥ 0.92"),
    "on the focus": ("≥ 0.88", "≥ 0.95"),
}

READERS = ("a.jsonl", "b.jsonl", "c.jsonl")

LOUDNESS_AGITATION = {
    -1: Agitation(low=0.7, medium=0.25, high=0.05),
    0: Agitation(low=0.1, medium=0.8, high=0.1),
    1: Agitation(low=0.05, medium=0.25, high=0.7),
}


def load_deliveries(folder: Path, score: ModuleType) -> Any:  # noqa: ANN401 - a module found at run time
    """deliveries.py as a module, which measures with this score.py."""
    sys.modules["score"] = score
    specification = importlib.util.spec_from_file_location("deliveries", folder / "deliveries.py")
    assert specification is not None
    assert specification.loader is not None
    deliveries = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(deliveries)
    return deliveries


def as_written(utterance: Utterance, line: Mapping[str, Any]) -> Utterance:
    """The utterance with the focus, tone and loudness that the speaker was given."""
    share = 1 / max(len(line["focus"]), 1)
    (activation, valence, dominance), shares = TONES[line["tone"]]
    tones = tuple(shares.get(tone, 0.0) for tone in Tone)
    return replace(
        utterance,
        words=tuple(replace(word, focus=share * (word.index in line["focus"])) for word in utterance.words),
        affect=LineAffect(Affect(activation, valence, dominance, tones)),
        agitation=LOUDNESS_AGITATION[line["loudness"]],
    )


def measure(directing: Path, options: Options, *, told: bool) -> dict[str, float]:
    """Performs the deliveries and prints the figures; `told` the performance knows them as written. Returns them."""
    folder = directing / "deliveries"
    lines = [json.loads(line) for line in (folder / "lines.jsonl").read_text(encoding="utf-8").splitlines()]
    did = {}
    with Understudy.load(Settings()) as understudy:
        score = load_score(directing, understudy.behavior.families.shows)
        for line in lines:
            text = " ".join(word.split(":", 1)[1] for word in line["words"])
            audio = (folder / "audio" / f"{line['id']}.flac").read_bytes()
            analysis = analyze(understudy, Line(audio, text))
            if told:
                analysis = replace(analysis, utterance=as_written(analysis.utterance, line))
            performance = perform_analysis(understudy, analysis, options)
            did[line["id"]] = (gestures_of(score, performance), *others_of(score, performance))
    directors = [score.read(folder / name) for name in READERS]
    records = {name: [director[name] for director in directors] for name in did}
    deliveries = load_deliveries(directing, score)
    _f, apart, focused = deliveries.report(f"{len(did)} deliveries", lines, records, did)
    counts = sum((deliveries.counts(records[name], each) for name, each in did.items()), Counter[str]())
    own = {"told apart": round(apart, 3), "on the focus": round(focused, 3)}
    return agreement(score, counts, len(did)) | own


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    parser.add_argument("--choice", choices=("terms", "priority"), default="terms")
    parser.add_argument("--as-written", action="store_true")
    parser.add_argument("--seed", type=int, default=0)
    add_record_option(parser)
    arguments = parser.parse_args()
    os.environ["UNDERSTUDY_CHOICE"] = arguments.choice
    figures = measure(arguments.directing, Options(seed=arguments.seed), told=arguments.as_written)
    if arguments.record:
        record_all("84 deliveries", figures, BARS)


if __name__ == "__main__":
    main()
