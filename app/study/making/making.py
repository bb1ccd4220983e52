"""A study, in order: read the lines, perform each in every condition, render the clips, write page and key.

A line whose conditions look alike is reported and skipped; if no line differs, the study is refused.
"""

import csv
import hashlib
import io
import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

from ...batch.work.files import write_whole
from ...errors import InputError
from ...library.motion import PreparedSchedule, RealizedSchedule
from ...model import Behavior, Channel, Notice
from ...models import Understudy
from ..comparison import CONDITIONS, KEY_COLUMNS, KEY_NAME, Comparison
from ..request import PAGE_FOLDER, StudyRequest
from .clips import blind_clip, blind_sound, body_of, realized
from .lines import StudyLine, read_lines
from .singletons import in_modes, in_units_and_singly
from .site import CLIPS, CODE_LENGTH, LinePage, Site, script_of, script_of_bytes, write_site

ADVICE: Mapping[Comparison, str] = {
    Comparison.MODES: "take lines of more words",
    Comparison.UNITS: "take lines of 11 to 28 s, in which units have several gestures, or another profile or seed",
}
"""What would give a difference, by what is compared."""

Told = Callable[[str, Sequence[Notice]], None]
"""Is told of each line when its clips are made: its name and what they have, and its notices."""


@dataclass(frozen=True, slots=True)
class RenderedLine:
    """A line's clips by condition, each its motion as JSON, its recording, who moves, and whether the conditions can be
    told apart."""

    id: str
    clips: Mapping[str, str]
    sound: bytes
    character: str
    differs: bool


@dataclass(frozen=True, slots=True)
class _Motions:
    """A line's motions by condition, the notices about them, and the reason if they look alike."""

    by_condition: Mapping[str, RealizedSchedule]
    told: str
    alike: str = ""


def make_study(request: StudyRequest, models: Understudy, told: Told) -> int:
    """Writes the page, and the key that says what its clips show; how many lines are on it.

    Raises InputError where lines cannot be read or performed, none shows a difference, or nothing can be written.
    """
    every = [_rendered(request, models, line, told) for line in read_lines(request.source, request.options)]
    rendered = [line for line in every if line.differs]
    if not rendered:
        message = (
            f"{request.source.lines}: nobody could tell the conditions of any line apart; {ADVICE[request.comparison]}"
        )
        raise InputError("study_lines", message, field="lines")
    coding = _Coding(request, [each.id for each in rendered])
    bodies = {each.character: body_of(models, each.character) for each in rendered}
    site = Site(
        name=coding.code("study"),
        comparison=request.comparison,
        lines=tuple(coding.page_of(each) for each in rendered),
        files=dict(_files(rendered, bodies, coding)),
    )
    write_site(request.source.out / PAGE_FOLDER, site)
    _write_key(request, rendered, coding)
    return len(rendered)


def _rendered(request: StudyRequest, models: Understudy, line: StudyLine, told: Told) -> RenderedLine:
    """Raises InputError with the line's name."""
    motions_of = {Comparison.MODES: _in_modes, Comparison.UNITS: _in_versions}[request.comparison]
    try:
        motions = motions_of(models, line)
        sound = blind_sound(line.line.recording)
    except InputError as error:
        raise InputError(error.code, f"line {line.id!r}: {error.message}", field=error.field) from None
    clips = {name: blind_clip(models, motion) for name, motion in motions.by_condition.items()}
    left_out = f"; {motions.alike}: left out" if motions.alike else ""
    notices = next(iter(motions.by_condition.values())).motion.notices
    told(f"{line.id}: {motions.told}{left_out}", notices)
    return RenderedLine(line.id, clips, sound, line.options.character, not motions.alike)


def _in_modes(models: Understudy, line: StudyLine) -> _Motions:
    performances = in_modes(models, line)
    motions = {name: realized(models, PreparedSchedule.of(each)) for name, each in performances.items()}
    gestures = {name: [each for each in found.behaviors if _is_made(each)] for name, found in performances.items()}
    same = [f"{one} and {other}" for one, other in combinations(gestures, 2) if _alike(gestures[one], gestures[other])]
    told = f"gestures: {', '.join(f'{name} {len(made)}' for name, made in gestures.items())}"
    return _Motions(motions, told, f"{', '.join(same)} have the same gestures" if same else "")


def _alike(*performances: Sequence[Behavior]) -> bool:
    one, other = ([(each.lexeme, each.hand, each.sync) for each in found] for found in performances)
    return one == other


def _is_made(behavior: Behavior) -> bool:
    return behavior.kept and behavior.kind is Channel.GESTURE


def _in_versions(models: Understudy, line: StudyLine) -> _Motions:
    found = in_units_and_singly(models, line)
    told = f"{found.gestures} gestures, {found.rests} holds of U are rests in S, {found.given_up} had no time to rest"
    return _Motions(found.motions, told, "" if found.rests else "both versions are the same")


class _Coding:
    """Opaque names, the same whenever the same study is made."""

    def __init__(self, request: StudyRequest, lines: Sequence[str]) -> None:
        self._of = f"{request.comparison} {request.seed} {' '.join(lines)}"
        self._conditions = CONDITIONS[request.comparison]
        self._rng = random.Random(self._of)

    def code(self, *named: str) -> str:
        """A name of hexadecimal digits."""
        return hashlib.sha256(" ".join((self._of, *named)).encode()).hexdigest()[:CODE_LENGTH]

    def page_of(self, line: RenderedLine) -> LinePage:
        clips = [self.code(line.id, condition) for condition in self._conditions]
        self._rng.shuffle(clips)
        return LinePage(self.code(line.id, "sound"), self.code(line.character, "body"), tuple(clips))


def _files(
    rendered: Sequence[RenderedLine], bodies: Mapping[str, bytes], coding: _Coding
) -> Iterator[tuple[str, bytes]]:
    """The files beside the page."""
    for character, body in bodies.items():
        name = coding.code(character, "body")
        yield f"{CLIPS}/{name}.js", script_of_bytes(name, body)
    for line in rendered:
        yield f"{CLIPS}/{coding.code(line.id, 'sound')}.flac", line.sound
        for condition, clip in line.clips.items():
            name = coding.code(line.id, condition)
            yield f"{CLIPS}/{name}.js", script_of(name, clip)


def _write_key(request: StudyRequest, rendered: Sequence[RenderedLine], coding: _Coding) -> None:
    content = io.StringIO()
    writer = csv.writer(content, lineterminator="\n")
    writer.writerow(KEY_COLUMNS)
    for line in rendered:
        writer.writerows((coding.code(line.id, condition), line.id, condition) for condition in line.clips)
    write_whole(request.source.out, KEY_NAME, content.getvalue().encode())
