"""How often correct and wrong texts are refused and warned about.

    python -m benchmarks.acoustic.transcripts [--shared ../shared] [--every N] [--all-acted]

Material: `training/alignment/transcripts.py`. The weights were fitted to it; `python -m training.alignment.misfit`
prints the accuracy on material they were not fitted to.
"""

import argparse
from collections import defaultdict
from pathlib import Path

from benchmarks.acoustic.alignment import ROOT, outcome, print_outcomes
from training.alignment.transcripts import RAVDESS_STEP, read_recordings, texts_for
from understudy.acoustic.alignment.aligner import Aligner


def main() -> None:
    """Prints a row for each kind of text and recording."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shared", type=Path, default=ROOT.parent / "shared")
    parser.add_argument("--all-acted", action="store_true", help="every recording of RAVDESS, not one in six")
    parser.add_argument("--every", type=int, default=1, help="only every Nth recording")
    options = parser.parse_args()
    recordings = read_recordings(options.shared, 1 if options.all_acted else RAVDESS_STEP)
    outcomes: dict[str, list[str]] = defaultdict(list)
    with Aligner(ROOT / "models", ROOT / "lexicon" / "en") as aligner:
        for number in range(0, len(recordings), options.every):
            for kind, text in texts_for(recordings, number):
                found = outcome(aligner, recordings[number].audio, text)
                outcomes[f"{kind}, all"].append(found)
                outcomes[f"{kind}, {recordings[number].kind}"].append(found)
    for name in sorted(outcomes):
        print_outcomes(f"{name:40}", outcomes[name])


if __name__ == "__main__":
    main()
