"""The feeling that an author gives instead of what is heard: a tone ("sad"), activation, valence and dominance
("0.6,-0.5,0.3"), or a track of these over time.

A track is CSV with the header `time_s,activation,valence,dominance` and a row for each time, rising; between two rows
the feeling changes evenly (continuous annotation as in Bozkurt et al., *Affect-Expressive Hand Gestures*, §3).
"""

import csv
import io
import math
from collections.abc import Iterator, Sequence

from ..errors import InputError, shown
from ..model import Affect, AffectTrack, Tone
from ..model.voice.affect import affect_of_dimensions, affect_of_tone

HEADER = ("time_s", "activation", "valence", "dominance")
MOST_ROWS = 100_000
AFFECT_FORMS = (
    f"a tone ({', '.join(Tone)}), activation,valence,dominance from -1 to 1, or a track of these "
    "(in JSON rows of a time in seconds and the three, else CSV)"
)
"""What can be given, for messages."""


def constant_affect(affect: Affect) -> AffectTrack:
    """One feeling from beginning to end."""
    return AffectTrack((0.0,), (affect,))


def read_affect(text: str) -> AffectTrack:
    """The feeling of a tone's name or of "activation,valence,dominance"; raises InputError `affect_wrong`."""
    if text.strip() in set(Tone):
        return constant_affect(affect_of_tone(Tone(text.strip())))
    numbers = text.split(",")
    if len(numbers) != 3:
        raise _wrong(f"{shown(text)} is neither a tone nor three numbers")
    return constant_affect(affect_of_dimensions(*(_number(part, text) for part in numbers)))


def affect_track(given: str | Sequence[float] | Sequence[Sequence[float]]) -> AffectTrack:
    """The feeling in JSON: a tone, three numbers, or a track of rows of four; raises InputError `affect_wrong`."""
    if isinstance(given, str):
        return read_affect(given)
    rows = [row for row in given if isinstance(row, Sequence)]
    if rows:
        return _track([[str(number) for number in row] for row in rows], "row ")
    return read_affect(",".join(map(str, given)))


def affect_rows(track: AffectTrack) -> str | list[list[float]]:
    """The same in JSON, for `affect_track`."""
    if len(track.affects) == 1 and max(track.affects[0].tones) == 1:
        return track.affects[0].tone.value
    numbers = [[each.activation, each.valence, each.dominance] for each in track.affects]
    return [[time_s, *row] for time_s, row in zip(track.times_s, numbers, strict=True)]


def read_affect_track(content: bytes, name: str) -> AffectTrack:
    """The track in the CSV file `name`; raises InputError `affect_wrong` with its line."""
    try:
        rows = [row for row in csv.reader(io.StringIO(content.decode("utf-8-sig"))) if any(map(str.strip, row))]
    except (UnicodeDecodeError, csv.Error) as error:
        raise _wrong(f"{name}: not CSV in UTF-8 ({error})") from None
    if not rows or tuple(cell.strip() for cell in rows[0]) != HEADER or len(rows) < 2:
        raise _wrong(f"{name}: the first line must be {','.join(HEADER)}, with a row for each time below it")
    if len(rows) > MOST_ROWS:
        raise _wrong(f"{name}: {len(rows)} rows; {MOST_ROWS} at most")
    return _track(rows[1:], f"{name}:", first=2)


def _track(rows: Sequence[Sequence[str]], name: str, *, first: int = 1) -> AffectTrack:
    """The track in rows of cells, of which the first is number `first` of what is called `name`."""
    points = list(_points(rows, name, first))
    return AffectTrack(tuple(time_s for time_s, _affect in points), tuple(affect for _time_s, affect in points))


def _points(rows: Sequence[Sequence[str]], name: str, first: int) -> Iterator[tuple[float, Affect]]:
    before_s = -math.inf
    for line, row in enumerate(rows, start=first):
        where = f"{name}{line}"
        if len(row) != len(HEADER):
            raise _wrong(f"{where}: {len(row)} cells; there are {len(HEADER)}: {', '.join(HEADER)}")
        time_s = _time(row[0], where)
        if time_s <= before_s:
            raise _wrong(f"{where}: the time {time_s:g} s is not after that of the row above")
        before_s = time_s
        yield time_s, affect_of_dimensions(*(_number(cell, where) for cell in row[1:]))


def _time(cell: str, where: str) -> float:
    try:
        time_s = float(cell)
    except ValueError:
        time_s = math.nan
    if not 0 <= time_s < math.inf:
        raise _wrong(f"{where}: {shown(cell)} is not a time in seconds")
    return time_s


def _number(cell: str, where: str) -> float:
    try:
        number = float(cell)
    except ValueError:
        number = math.nan
    if not -1 <= number <= 1:
        raise _wrong(f"{shown(where)}: {shown(cell.strip())} is not a number from -1 to 1")
    return number


def _wrong(message: str) -> InputError:
    return InputError("affect_wrong", f"affect: {message}; give {AFFECT_FORMS}", field="affect")
