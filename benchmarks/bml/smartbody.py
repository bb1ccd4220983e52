"""Whether SmartBody can play what we write for it, and how many of our gestures its map has.

    python -m benchmarks.bml.smartbody [--lines FOLDER…]

Every recorded line (NAME.flac with NAME.txt; default: the examples and ../shared/data/speech/lines) is written for
SmartBody, with absolute times and from marks, to nobody and to a listener, and checked against what a SmartBody that
was built accepts (`tests.support.bml.smartbody_checker`). Then the gestures of the table are counted that its gesture
map has by type, with their hand, and with hand and style.
"""

import argparse
from collections.abc import Iterator, Sequence
from itertools import product
from pathlib import Path

from tests.support.bml.smartbody_checker import check_act, check_speech_file
from understudy.behavior.table.behavior_table import load_table
from understudy.bml.writing.smartbody_tables import shipped_tables
from understudy.bml.writing.writer import losses, write_bml, write_speech_file
from understudy.files import resource_folder
from understudy.model import Channel, Line, Performance
from understudy.model.formats import BmlForm, DialectName, TimeForm
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.settings import Settings

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = (ROOT / "examples", ROOT.parent / "shared" / "data" / "speech" / "lines")
LISTENER = "anna"
STYLES = ("low", "mid", "high")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--lines", type=Path, nargs="+", default=FOLDERS, help="folders of recorded lines")
    _count_documents(parser.parse_args().lines)
    _count_gestures()


def _count_documents(folders: Sequence[Path]) -> None:
    played = documents = 0
    with Understudy.load(Settings()) as understudy:
        for audio, performance in _performances(understudy, folders):
            for timing in TimeForm:
                mistakes = list(_mistakes(performance, BmlForm(DialectName.SMARTBODY, timing, audio.name)))
                documents += 1
                played += not mistakes
                for mistake in mistakes:
                    print(f"{audio.name} {timing}: {mistake}")
    print(f"{played} of {documents} documents with their speech files have nothing that SmartBody refuses")


def _performances(understudy: Understudy, folders: Sequence[Path]) -> Iterator[tuple[Path, Performance]]:
    for audio in sorted(audio for folder in folders for audio in folder.glob("*.flac")):
        line = Line(audio.read_bytes(), audio.with_suffix(".txt").read_text(encoding="utf-8"))
        for listeners in ((), (LISTENER,)):
            yield audio, perform(understudy, line, Options(listeners=listeners))


def _mistakes(performance: Performance, form: BmlForm) -> Iterator[str]:
    act, beside = write_bml(performance, form), write_speech_file(performance, form)
    yield from check_act(act, frozenset(listening.name for listening in performance.listeners))
    yield from check_speech_file(beside.content, act) if beside else ("no speech file",)
    codes = [notice.code for notice in losses(performance, form)]
    if codes != ([] if performance.listeners else ["smartbody_gaze"]):
        yield f"notices {codes}"


def _count_gestures() -> None:
    table, tables = load_table(resource_folder("lexicon") / "behaviors.yaml"), shipped_tables()
    entries = {(each.lexeme, each.hand) for each in map(table.entry, table.lines) if each.channel is Channel.GESTURE}
    found = [(hand, tables.gesture(lexeme, hand, None)) for lexeme, hand in entries]
    handed = [(hand, name) for hand, name in found if hand]
    styled = sum(bool(tables.gesture(*entry, style).style) for entry, style in product(entries, STYLES))
    print(f"gestures of the table, lexeme and hand: {len(entries)}")
    print(f"found by type: {sum(name.type in tables.gesture_map for _, name in found)}")
    print(f"found with their hand: {sum(name.hand is hand for hand, name in handed)} of {len(handed)} with one")
    print(f"found with {', '.join(STYLES)}: {styled} of {len(STYLES) * len(entries)}")


if __name__ == "__main__":
    main()
