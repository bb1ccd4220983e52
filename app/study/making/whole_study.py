"""A study, in order: read the lines, perform each in every condition, render the clips, write page and key.

A line whose conditions look alike is reported and skipped; if no line differs, the study is refused. In comparisons of
ways and of affect each round shows a pair of clips, as in the thesis (RTS §3.2): seven rounds show each pair of
conditions twice and one pair of identical clips. In a comparison of speakers the first line introduces the speakers.
"""

from __future__ import annotations

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
from ..comparison import CONDITIONS, KEY_COLUMNS, KEY_NAME, PAIRED, Comparison
from .conditions import by_speakers, driven_by_affect, in_modes, in_units_and_singly, in_ways
from .lines import PAGE_FOLDER, StudyLine, StudyRequest, read_lines
from .site import (
    CLIPS,
    CODE_LENGTH,
    LinePage,
    Site,
    blind_clip,
    blind_sound,
    body_of,
    realized,
    script_of,
    script_of_bytes,
    write_site,
)

ADVICE: Mapping[Comparison, str] = {
    Comparison.MODES: "take lines of more words",
    Comparison.UNITS: "take lines of 11 to 28 s, in which units have several gestures, or another profile or seed",
    Comparison.SPEAKERS: "take longer lines, or profiles that differ more",
}
"""Advice for lines without a visible difference, by comparison."""

FEWEST_OF_SPEAKERS = 2
AGAIN = "again"
"""Suffix of the name of the second clip in an identical pair."""

LineReport = Callable[[str, Sequence[Notice]], None]
"""Called when a line's clips are made, with a message (the line's name and a summary of its clips) and its notices."""


@dataclass(frozen=True, slots=True)
class RenderedLine:
    """A rendered line: its motion (JSON) in each condition, its recording, its character, and whether its conditions
    differ visibly."""

    id: str
    clips: Mapping[str, str]
    sound: bytes
    character: str
    differs: bool


@dataclass(frozen=True, slots=True)
class _Motions:
    """A line's motions by condition, the notices about them, and the reason if they look alike."""

    by_condition: Mapping[str, RealizedSchedule]
    summary: str
    alike: str = ""


def make_study(request: StudyRequest, models: Understudy, report: LineReport) -> int:
    """Writes the page and the key of its clips; returns the number of rounds.

    Raises InputError if a line cannot be read or performed, if no line shows a difference, or if the files cannot be
    written.
    """
    every = [_rendered(request, models, line, report) for line in read_lines(request.source, request.options)]
    rendered = [line for line in every if line.differs]
    if not rendered:
        advice = ADVICE.get(request.comparison, "take other lines")
        message = f"{request.source.lines}: the conditions differ visibly in no line; {advice}"
        raise InputError("study_lines", message, field="lines")
    if request.comparison is Comparison.SPEAKERS and len(rendered) < FEWEST_OF_SPEAKERS:
        message = (
            f"{request.source.lines}: only one line has a difference; give another, since the first shows who is who"
        )
        raise InputError("study_lines", message, field="lines")
    coding = _Coding(request, [each.id for each in rendered])
    rounds, again = _rounds(request, rendered, coding)
    bodies = {each.character: body_of(models, each.character) for each in rendered}
    site = Site(
        name=coding.code("study"),
        comparison=request.comparison,
        lines=rounds,
        training=coding.training_of(rendered[0]) if request.comparison is Comparison.SPEAKERS else (),
        files=dict(_files(rendered, bodies, coding, again)),
    )
    write_site(request.source.out / PAGE_FOLDER, site)
    _write_key(request, rendered, coding, again)
    return len(rounds)


def _rounds(
    request: StudyRequest, rendered: Sequence[RenderedLine], coding: _Coding
) -> tuple[tuple[LinePage, ...], Mapping[str, str]]:
    """The rounds of the page, and the condition shown in each identical pair, by line."""
    if request.comparison is Comparison.SPEAKERS:
        return tuple(coding.page_of(each, [*each.clips]) for each in rendered[1:]), {}
    conditions = CONDITIONS[request.comparison]
    if request.comparison not in PAIRED:
        return tuple(coding.page_of(each, conditions) for each in rendered), {}
    pairs, rounds, again = [*combinations(conditions, 2)] * 2, list[LinePage](), dict[str, str]()
    for number in range(max(len(pairs) + 1, len(rendered))):
        line, turn = rendered[number % len(rendered)], number % (len(pairs) + 1)
        if turn < len(pairs):
            rounds.append(coding.page_of(line, pairs[turn]))
        elif line.id not in again:
            again[line.id] = conditions[request.seed % len(conditions)]
            rounds.append(coding.page_of(line, (again[line.id],), AGAIN))
    return tuple(rounds), again


def _rendered(request: StudyRequest, models: Understudy, line: StudyLine, report: LineReport) -> RenderedLine:
    """Raises InputError with the line's name."""
    try:
        motions = _motions(request, models, line)
        sound = blind_sound(line.line.recording)
    except InputError as error:
        raise InputError(error.code, f"line {line.id!r}: {error.message}", field=error.field) from None
    clips = {name: blind_clip(models, motion) for name, motion in motions.by_condition.items()}
    left_out = f"; {motions.alike}: left out" if motions.alike else ""
    notices = next(iter(motions.by_condition.values())).motion.notices
    report(f"{line.id}: {motions.summary}{left_out}", notices)
    return RenderedLine(line.id, clips, sound, line.options.character, not motions.alike)


def _motions(request: StudyRequest, models: Understudy, line: StudyLine) -> _Motions:
    match request.comparison:
        case Comparison.MODES:
            return _in_modes(models, line)
        case Comparison.UNITS:
            return _in_versions(models, line)
        case Comparison.SPEAKERS:
            return _gesturing(by_speakers(models, request.speakers, line))
    assert request.model is not None, "ways and affect have a model"
    if request.comparison is Comparison.WAYS:
        return _Motions(in_ways(models, request.model, line, request.seed), f"moved by {request.model.about}")
    return _Motions(driven_by_affect(models, request.model, line), f"moved by {request.model.about}")


def _gesturing(found: Mapping[str, RealizedSchedule]) -> _Motions:
    gestures = {name: [each for each in one.schedule.behaviors if _is_made(each)] for name, one in found.items()}
    summary = f"gestures: {', '.join(f'{name} {len(made)}' for name, made in gestures.items())}"
    return _Motions(found, summary, "both have the same gestures" if _alike(*gestures.values()) else "")


def _in_modes(models: Understudy, line: StudyLine) -> _Motions:
    performances = in_modes(models, line)
    motions = {name: realized(models, PreparedSchedule.of(each)) for name, each in performances.items()}
    gestures = {name: [each for each in found.behaviors if _is_made(each)] for name, found in performances.items()}
    same = [f"{one} and {other}" for one, other in combinations(gestures, 2) if _alike(gestures[one], gestures[other])]
    summary = f"gestures: {', '.join(f'{name} {len(made)}' for name, made in gestures.items())}"
    return _Motions(motions, summary, f"{', '.join(same)} have the same gestures" if same else "")


def _alike(*performances: Sequence[Behavior]) -> bool:
    one, other = ([(each.lexeme, each.hand, each.sync) for each in found] for found in performances)
    return one == other


def _is_made(behavior: Behavior) -> bool:
    return behavior.kept and behavior.kind is Channel.GESTURE


def _in_versions(models: Understudy, line: StudyLine) -> _Motions:
    found = in_units_and_singly(models, line)
    summary = (
        f"{found.gestures} gestures, {found.rests} holds of U are rests in S, {found.given_up} had no time to rest"
    )
    return _Motions(found.motions, summary, "" if found.rests else "both versions are the same")


class _Coding:
    """Assigns opaque names, which are the same whenever the same study is made."""

    def __init__(self, request: StudyRequest, lines: Sequence[str]) -> None:
        self._of = f"{request.comparison} {request.seed} {' '.join(lines)}"
        self._rng = random.Random(self._of)

    def code(self, *named: str) -> str:
        """A name of hexadecimal digits."""
        return hashlib.sha256(" ".join((self._of, *named)).encode()).hexdigest()[:CODE_LENGTH]

    def page_of(self, line: RenderedLine, conditions: Sequence[str], *again: str) -> LinePage:
        """The clips of these conditions in random order; with `again` the first of them and its copy."""
        clips = [self.code(line.id, condition) for condition in conditions]
        clips += [self.code(line.id, conditions[0], *again)] if again else []
        self._rng.shuffle(clips)
        return LinePage(self.code(line.id, "sound"), self.code(line.character, "body"), tuple(clips))

    def training_of(self, line: RenderedLine) -> tuple[tuple[str, LinePage], ...]:
        """The line's clip of each speaker, by the speaker's name."""
        return tuple((name, self.page_of(line, [name])) for name in line.clips)


def _files(
    rendered: Sequence[RenderedLine], bodies: Mapping[str, bytes], coding: _Coding, again: Mapping[str, str]
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
        if line.id in again:
            name = coding.code(line.id, again[line.id], AGAIN)
            yield f"{CLIPS}/{name}.js", script_of(name, line.clips[again[line.id]])


def _write_key(
    request: StudyRequest, rendered: Sequence[RenderedLine], coding: _Coding, again: Mapping[str, str]
) -> None:
    content = io.StringIO()
    writer = csv.writer(content, lineterminator="\n")
    writer.writerow(KEY_COLUMNS)
    for line in rendered:
        writer.writerows((coding.code(line.id, condition), line.id, condition) for condition in line.clips)
    writer.writerows((coding.code(line, condition, AGAIN), line, condition) for line, condition in again.items())
    write_whole(request.source.out, KEY_NAME, content.getvalue().encode())
