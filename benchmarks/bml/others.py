"""How many documents by others are realized, how many are refused and why, and whether any meets an untyped error.

    python -m benchmarks.bml.others [FOLDER…] [--record]

Every .xml and .bml file in the folders is realized without a recording. Default: the suite by which BML 1.0's realizers
were compared (../shared/data/bml/realizertester-bml1), of which two are wrong on purpose, and our own documents in the
manner of SmartBody's, ASAP's and Greta's (tests/bml/reading/documents).
"""

import argparse
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from benchmarks.figures import add_record_option, record
from understudy.errors import UnderstudyError
from understudy.models import load_realizer
from understudy.realization.bml import BmlInput, prepare_schedule
from understudy.realization.motion import realize_prepared
from understudy.realizer.realizing import Realizer

ROOT = Path(__file__).resolve().parents[2]
SUITE = ROOT.parent / "shared" / "data" / "bml" / "realizertester-bml1"
FOLDERS = (SUITE, ROOT / "tests" / "bml" / "reading" / "documents")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", type=Path, nargs="*", default=FOLDERS)
    add_record_option(parser)
    options = parser.parse_args()
    paths = list(_documents(options.folders))
    realizer = load_realizer()
    outcomes = Counter(_outcome(realizer, path) for path in paths)
    print(f"{len(paths)} documents: " + ", ".join(f"{count} {name}" for name, count in outcomes.most_common()))
    if options.record:
        record("formats", "BML by others: documents realized", outcomes["realized"] / len(paths), "of all")
        record("formats", "BML by others: untyped errors", float(outcomes["broken"]), bar="= 0")


def _documents(folders: Sequence[Path]) -> Iterator[Path]:
    for folder in folders:
        yield from sorted(path for path in folder.rglob("*") if path.suffix in {".xml", ".bml"})


def _outcome(realizer: Realizer, path: Path) -> str:
    try:
        realized = realize_prepared(realizer, prepare_schedule(None, BmlInput(path.read_bytes(), path)))
    except UnderstudyError as error:
        print(f"refused: {error.message}")
        return "refused"
    except Exception as error:  # noqa: BLE001 - what is counted
        print(f"broken: {path}: {error!r}")
        return "broken"
    codes = Counter(notice.code for notice in realized.motion.notices)
    print(f"realized: {path.name}: " + ", ".join(f"{count} × {code}" for code, count in sorted(codes.items())))
    return "realized"


if __name__ == "__main__":
    main()
