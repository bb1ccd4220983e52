"""Whether a profile's gestures resemble the speaker's: recognition, agreement with the annotation's statistics, smooth
mixing.

    python -m benchmarks.profiles [--seeds N] [--lines FILE]

Fidelity: gestures for the words of each example annotation by its speaker's profile, with `seeds` seeds, against the
annotation; beside it the paper's own choice, the likeliest sequence. Recognition: the lines of the marked dialogue
(../shared/data/functions) with made-up times, by both speakers. Mixing: profiles between the two on the same words.
"""

import argparse
import json
from collections.abc import Sequence
from pathlib import Path

from benchmarks.profiles.recognition import GROUPS, accuracy
from benchmarks.profiles.scripts import (
    AnnotatedSpeaker,
    annotated_scripts,
    default_repertoire,
    example_speakers,
    line_scripts,
)
from benchmarks.profiles.statistics import Statistics, annotated_statistics, chance, moved, scripted_statistics
from understudy.model import Hand
from understudy.models import Understudy
from understudy.profiles.generation.candidates import Repertoire
from understudy.profiles.generation.generating import Speaker, generate
from understudy.profiles.mixing import mix
from understudy.settings import Settings

LINES = Path(__file__).resolve().parents[3] / "shared" / "data" / "functions" / "dev.jsonl"
FEWEST_WORDS = 8
SHARES = (0.0, 0.25, 0.5, 0.75, 1.0)
PAPER_UNITS = {
    "NGS, JL": (35.7, 15.7, 17.1, 5.7, 11.4, 5.7, 8.6),
    "NGS, MR": (33.3, 16.7, 11.1, 14.8, 9.3, 3.7, 11.1),
    "McNeill": (56, 14, 8, 8, 4, 2, 8),
}


def main() -> None:
    """Prints the three."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--lines", type=Path, default=LINES)
    options = parser.parse_args()
    speakers = example_speakers()
    with Understudy.load(Settings()) as understudy:
        repertoire = default_repertoire(understudy)
        for speaker in speakers:
            _print_fidelity(speaker, repertoire, options.seeds)
        _print_units(speakers, repertoire, options.seeds)
        _print_recognition(understudy, repertoire, speakers, options.lines)
    _print_mixing(speakers, repertoire, options.seeds)


def _print_fidelity(speaker: AnnotatedSpeaker, repertoire: Repertoire, seeds: int) -> None:
    smoothing, words = speaker.profile.smoothing, speaker.annotation.words
    annotated = annotated_statistics(speaker.annotation)
    drawn = scripted_statistics(list(annotated_scripts(speaker, repertoire, seeds)), words, speaker.profile)
    likeliest = scripted_statistics(
        list(annotated_scripts(speaker, repertoire, 1, likeliest=True)), words, speaker.profile
    )
    print(
        f"\n{speaker.profile.name}: held-out {smoothing.held_out:.3f} nats a tag, blind to tags {smoothing.blind:.3f}"
    )
    print(f"{'':24}{'annotated':>11}{'drawn':>11}{'likeliest':>11}")
    for name, told in _rows(annotated):
        others = (dict(_rows(each))[name] for each in (drawn, likeliest))
        print(f"{name:24}{told:11.3f}" + "".join(f"{each:11.3f}" for each in others))
    for name in ("lexemes", "hands", "unit_sizes"):
        far = [moved(getattr(annotated, name), getattr(each, name)) for each in (drawn, likeliest)]
        print(f"{name + ', moved':24}{'':11}" + "".join(f"{each:11.1%}" for each in far))
    units = chance(drawn.unit_sizes, len(speaker.annotation.units))
    lexemes = chance(drawn.lexemes, len(speaker.annotation.phrases))
    print(f"by chance alone, so few: lexemes {lexemes:.1%}, unit sizes {units:.1%}")


def _rows(found: Statistics) -> list[tuple[str, float]]:
    hands = [(f"{hand} hand", found.hands.get(hand, 0.0)) for hand in Hand]
    names = ("per_minute", "mean_unit", "strokes", "offset_s", "offset_deviation_s")
    return [*((name, getattr(found, name)) for name in names), *hands]


def _print_units(speakers: Sequence[AnnotatedSpeaker], repertoire: Repertoire, seeds: int) -> None:
    print(f"\n{'units of, %':24}" + "".join(f"{size:>7}" for size in ("1", "2", "3", "4", "5", "6", ">6")))
    for name, row in PAPER_UNITS.items():
        print(f"{name:24}" + "".join(f"{share:7.1f}" for share in row))
    for speaker in speakers:
        annotated = annotated_statistics(speaker.annotation)
        scripts = list(annotated_scripts(speaker, repertoire, seeds))
        drawn = scripted_statistics(scripts, speaker.annotation.words, speaker.profile)
        for kind, found in (("annotated", annotated), ("drawn", drawn)):
            shares = "".join(f"{100 * found.unit_sizes.get(size, 0.0):7.1f}" for size in range(1, 8))
            print(f"{speaker.profile.name + ', ' + kind:24}{shares}")


def _print_recognition(
    understudy: Understudy, repertoire: Repertoire, speakers: Sequence[AnnotatedSpeaker], lines: Path
) -> None:
    if not lines.exists():
        print(f"\nno recognition: {lines} is missing")
        return
    texts = [json.loads(line)["text"] for line in lines.read_text(encoding="utf-8").splitlines()]
    texts = [text for text in texts if len(text.split()) >= FEWEST_WORDS]
    one, other = line_scripts(understudy, repertoire, [each.profile for each in speakers], texts)
    print(f"\nrecognition on {len(texts)} lines, each half after the other half")
    for groups in (GROUPS, GROUPS[:-1], GROUPS[1:], *((group,) for group in GROUPS)):
        right, number = accuracy(one, other, groups)
        print(f"{', '.join(groups):40}{right:7.1%} of {number} scripts")


def _print_mixing(speakers: Sequence[AnnotatedSpeaker], repertoire: Repertoire, seeds: int) -> None:
    one, other = speakers
    ends = [annotated_statistics(each.annotation) for each in speakers]
    names = ("a minute", "left", "both", "unit", "strokes", "to 1st", "to 2nd")
    print(f"\n{'share of the second':24}" + "".join(f"{name:>9}" for name in names))
    for share in SHARES:
        profile = mix(one.profile, other.profile, share, name="mixed")
        tags = one.annotation.tags or ()
        scripts = [generate(Speaker(profile, repertoire, seed), one.utterance, tags) for seed in range(seeds)]
        found = scripted_statistics(scripts, one.annotation.words, profile)
        far = "".join(f"{moved(found.lexemes, end.lexemes):9.1%}" for end in ends)
        hands = "".join(f"{found.hands.get(hand, 0.0):9.1%}" for hand in (Hand.LEFT, Hand.BOTH))
        print(f"{share:<24.2f}{found.per_minute:9.1f}{hands}{found.mean_unit:9.2f}{found.strokes:9.2f}{far}")


if __name__ == "__main__":
    main()
