"""Time to write and read BML, and the reader's behaviour on hostile and broken files.

`python -m benchmarks.bml.bml` performs the bundled line once, then writes it in every form and reads it back. Then it
breaks the file at random, changing, dropping or doubling a few bytes, and reads that: each time there must be a
document or an InputError. Times are seconds of the processor, the median of `ROUNDS`.
"""

import argparse
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from random import Random
from statistics import median
from time import process_time

from benchmarks.figures import add_record_option, record
from understudy.bml.reading.reader import read_bml
from understudy.bml.writing.writer import write_bml
from understudy.errors import InputError
from understudy.model import Line, Performance
from understudy.model.formats import BmlForm, DialectName, TimeForm
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.settings import Settings

ROUNDS = 50
BROKEN = 20_000
EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "example.flac"
WRITTEN = Path("written.bml")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--broken", type=int, default=BROKEN, help="how many broken files are read")
    add_record_option(parser)
    arguments = parser.parse_args()
    performance = _performance()
    words = len(performance.utterance.words)
    print(f"the bundled line: {words} words, {sum(each.kept for each in performance.behaviors)} behaviours")
    forms = [BmlForm(dialect, timing) for dialect in DialectName for timing in TimeForm]
    times_s = {form: _times_s(performance, form) for form in forms}
    untyped = _break(write_bml(performance), arguments.broken)
    if arguments.record:
        writing_s, reading_s = times_s[BmlForm()]
        record("formats", "BML: writing the bundled line", round(writing_s * 1e3, 2), "ms")
        record("formats", "BML: reading the bundled line", round(reading_s * 1e3, 2), "ms")
        name = f"BML: broken files that bring an untyped error, of {arguments.broken:,}"
        record("formats", name, float(untyped), bar="= 0")
    for name, content in _hostile():
        taken_s = _seconds(lambda content=content: _read(content))  # type: ignore[misc]
        print(f"{name:44s} {len(content) / 1e6:5.1f} MB  {_read(content):8s} {taken_s * 1e3:8.1f} ms")


def _performance() -> Performance:
    with Understudy.load(Settings()) as understudy:
        line = Line(EXAMPLE.read_bytes(), EXAMPLE.with_suffix(".txt").read_text(encoding="utf-8"))
        return perform(understudy, line, Options())


def _times_s(performance: Performance, form: BmlForm) -> tuple[float, float]:
    """The times to write and to read a form."""
    content = write_bml(performance, form)
    document, _ = read_bml(content, WRITTEN)
    writing_s = median(_seconds(lambda: write_bml(performance, form)) for _ in range(ROUNDS))
    reading_s = median(_seconds(lambda: read_bml(content, WRITTEN)) for _ in range(ROUNDS))
    same = write_bml(performance, form) == content and document == read_bml(content, WRITTEN)[0]
    row = f"{form.dialect} {form.timing}: {len(content)} bytes"
    print(f"{row:44s} write {writing_s * 1e3:5.2f} ms  read {reading_s * 1e3:5.2f} ms  same again: {same}")
    return writing_s, reading_s


def _break(content: bytes, count: int) -> int:
    """The number of broken files that bring another error than an InputError."""
    random = Random(0)
    outcomes = [_read(_broken(content, random)) for _ in range(count)]
    counts = Counter(outcomes)
    print(f"{count} broken files: {counts['read']} read, {counts['refused']} refused, {counts['untyped']} untyped")
    return counts["untyped"]


def _broken(content: bytes, random: Random) -> bytes:
    """The file with one to three slips: a byte changed, a stretch dropped or doubled."""
    for _ in range(random.randint(1, 3)):
        at = random.randrange(len(content))
        stretch = content[at : at + random.randint(1, 30)]
        slip = random.choice([bytes([random.randrange(256)]), b"", stretch * 2])
        content = content[:at] + slip + content[at + len(stretch) :]
    return content


def _read(content: bytes) -> str:
    try:
        read_bml(content, WRITTEN)
    except InputError:
        return "refused"
    except Exception:  # noqa: BLE001 - what is counted
        return "untyped"
    return "read"


def _hostile() -> list[tuple[str, bytes]]:
    """Large files that would take long if any step took more than its share."""
    root = b'<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="b">%s</bml>'
    gazes = b"".join(
        b'<gaze id="g%d" target="t" start="%d" end="%d"/>' % (each, each, each + 1) for each in range(18_000)
    )
    heads = b"".join(b'<head id="h%d" lexeme="NOD" start="h%d:end"/>' % (each, each + 1) for each in range(20_000))
    marks = b"".join(b'<sync id="w%d"/>a ' % each for each in range(30_000))
    speech = b'<speech id="s"><text>%s</text></speech>' % marks
    nods = b"".join(b'<head id="h%d" lexeme="NOD" start="s:w%d"/>' % (each, each) for each in range(9_000))
    return [
        ("18,000 gazes one after the other", root % gazes),
        ("20,000 heads, each after the next, one missing", root % heads),
        ("30,000 marks, 9,000 references", root % (speech + nods)),
        ("140,000 unknown elements", root % (b"<wave/>" * 140_000)),
        ("70,000 elements of extensions", root % (b'<x xmlns="u"/>' * 70_000)),
        ("one attribute of 1 MB", root % (b'<head id="h" lexeme="%s"/>' % (b"N" * 1_000_000))),
        ("a number of 1,000,000 digits", root % (b'<head id="h" lexeme="N" start="%s"/>' % (b"9" * 1_000_000))),
    ]


def _seconds(work: Callable[[], object]) -> float:
    started = process_time()
    work()
    return process_time() - started


if __name__ == "__main__":
    main()
