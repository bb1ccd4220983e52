"""Whether the face goes with the voice: strong acted clips, whose words say nothing of how they are meant.

    python -m benchmarks.behavior.acted_faces [--speech FOLDER] [--every N] [--record]

Performs RAVDESS' strong recordings of six emotions with their text. A face fits where the held expression is that of
the emotion's tone (`lexicon/acting/attitudes.yaml`), or where a smile, a frown, a sad or a disgusted face is one of the
emotion's. It contradicts where there is a smile on an unpleasant emotion, or one of the other three on happiness. The
shipped model of affect was trained on other recordings of the same actors too; how well tones are told of actors that
were never heard is in `benchmarks.acoustic.affect`.
"""

import argparse
import csv
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import MappingProxyType

from benchmarks.acoustic.alignment import RAVDESS_TEXTS
from benchmarks.figures import add_record_option, record
from understudy.model import Channel, Line, Performance, Tone
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.settings import Settings

SPEECH = Path(__file__).resolve().parents[3] / "shared" / "data" / "speech"

TONES = MappingProxyType(
    {
        "happiness": Tone.HAPPY,
        "sadness": Tone.SAD,
        "anger": Tone.ANGRY,
        "fear": Tone.AFRAID,
        "disgust": Tone.DISGUSTED,
        "surprise": Tone.SURPRISED,
    }
)
SAYS: Mapping[str, str] = MappingProxyType(
    {
        "RAISE_MOUTH_CORNERS": "smile",
        "LOWER_BROWS": "frown",
        "OBLIQUE_BROWS": "sad",
        "LOWER_MOUTH_CORNERS": "sad",
        "WRINKLE_NOSE": "disgust",
    }
)
"""What a face says of a feeling; the others say too little."""

FITTING: Mapping[str, frozenset[str]] = MappingProxyType(
    {
        "happiness": frozenset({"smile"}),
        "sadness": frozenset({"sad"}),
        "anger": frozenset({"frown"}),
        "fear": frozenset({"sad"}),
        "disgust": frozenset({"disgust", "frown"}),
        "surprise": frozenset(),
    }
)
UNPLEASANT = frozenset({"sadness", "anger", "fear", "disgust"})


def fits(performance: Performance, emotion: str) -> bool:
    """Whether a face is one of the emotion's."""
    held = f"attitude_{TONES[emotion]}"
    return any(rule == held or SAYS.get(lexeme) in FITTING[emotion] for lexeme, rule in _faces(performance))


def contradicts(performance: Performance, emotion: str) -> bool:
    """Whether a face says the contrary of the emotion."""
    said = {SAYS[lexeme] for lexeme, _rule in _faces(performance) if lexeme in SAYS}
    return "smile" in said if emotion in UNPLEASANT else emotion == "happiness" and bool(said - {"smile"})


def _faces(performance: Performance) -> Iterator[tuple[str, str | None]]:
    yield from ((each.lexeme, each.rule) for each in performance.behaviors if each.kept and each.kind is Channel.FACE)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, default=SPEECH)
    parser.add_argument("--every", type=int, default=1, help="only every Nth recording")
    add_record_option(parser)
    options = parser.parse_args()
    with (options.speech / "labels.csv").open(encoding="utf-8") as file:
        strong = [row for row in csv.DictReader(file) if row["intensity"] == "strong" and row["emotion"] in TONES]
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    with Understudy.load(Settings()) as understudy:
        for row in strong[:: options.every]:
            line = Line((options.speech / row["file"]).read_bytes(), RAVDESS_TEXTS[row["sentence"]])
            performance, emotion = perform(understudy, line, Options()), row["emotion"]
            for name in (emotion, "all"):
                counts[name]["clips"] += 1
                counts[name]["fit"] += fits(performance, emotion)
                counts[name]["contradict"] += contradicts(performance, emotion)
    for name, count in counts.items():
        told = (f"{what} {count[what] / count['clips']:.3f}" for what in ("fit", "contradict"))
        print(f"{name}: {count['clips']} clips, {', '.join(told)}")
    if options.record:
        share = {what: counts["all"][what] / counts["all"]["clips"] for what in ("fit", "contradict")}
        record("choice", "strong acted clips: faces that fit", share["fit"], bar="≥ 0.65", aim="≥ 0.8")
        record("choice", "strong acted clips: faces that contradict", share["contradict"], bar="≤ 0.03", aim="= 0")


if __name__ == "__main__":
    main()
