"""`understudy profiles`: learns a speaker's gesture profile from annotation; mixes, lists and shows profiles."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

from ...errors import InputError
from ...loading import OnDemand
from ...models import load_characters, load_tags, profile_names
from ...profiles.annotation.elan import write_elan
from ...profiles.annotation.reading import LARGEST_BYTES, read_annotations, read_tracks
from ...profiles.annotation.tables import write_json_tracks
from ...profiles.annotation.tracks import KNOWN, PHRASE_ATTRIBUTES, Track, merged, rows_of, with_attribute_tracks
from ...profiles.files.writing import profile_yaml
from ...profiles.generation.script import RESTS, STANCES
from ...profiles.learning.learner import doubts
from ...profiles.mixing import mix
from ...profiles.proposing import ProposedUnit, proposed_tracks, proposed_units, read_wrists
from ...settings import read_settings
from ..files import STANDARD, read_bytes, require_writable, write, write_standard
from ..inputs.lines import named_profile
from ..log import Log
from ..outputs.listings import profile_lines

if TYPE_CHECKING:
    from ...models import LanguageModels


def run(arguments: argparse.Namespace, log: Log) -> int:
    actions = {"learn": _learn, "propose": _propose, "mix": _mix, "list": _list, "show": _show}
    actions[arguments.action](arguments, log)
    return 0


def _learn(arguments: argparse.Namespace, log: Log) -> None:
    from ...authoring.profile_learning import learn_profile

    require_writable(arguments.output, field="output")
    annotations = read_annotations(map(Path, arguments.files), load_characters().gesture_lexemes, load_tags())
    name = _name(arguments.output, arguments.files)
    profile = learn_profile(OnDemand(_language), annotations, name, arguments.description)
    write(arguments.output, profile_yaml(profile))
    log.note("\n".join(profile_lines(profile)))
    log.warnings(tuple(doubts(profile, annotations, (*STANCES, *RESTS.values()))))


def _language() -> LanguageModels:
    from ...models import LanguageModels

    return LanguageModels.load(read_settings())


def _propose(arguments: argparse.Namespace, log: Log) -> None:
    writers = {".eaf": _elan, ".json": write_json_tracks}
    suffix = PurePath(arguments.output).suffix.lower()
    if suffix not in writers:
        message = f"{arguments.output}: a proposed annotation is written as {' or '.join(writers)}"
        raise InputError("annotation_format", message, field="output")
    require_writable(arguments.output, field="output")
    if arguments.motion is None and arguments.words is None:
        raise InputError("usage", "nothing to propose from: give MOTION.bvh, --words FILE, or both", field="motion")
    read = merged(read_tracks(Path(arguments.words))) if arguments.words else ()
    others = [track for track in read if track.name in KNOWN]
    units = tuple(_units_in(arguments.motion)) if arguments.motion else ()
    write(arguments.output, writers[suffix](proposed_tracks(units, others)))
    found = (
        f"{sum(len(unit.phrases) for unit in units)} gestures in {len(units)} units; name them in {arguments.output}"
    )
    log.note(found if arguments.motion else f"the words, and empty tracks to annotate: {arguments.output}")


def _units_in(motion: str) -> Iterator[ProposedUnit]:
    content = read_bytes(motion, limit=LARGEST_BYTES, field="motion")
    yield from proposed_units(read_wrists(content, Path(motion)))


def _elan(tracks: Sequence[Track]) -> bytes:
    """ELAN tracks, with a tier for each attribute of phrases except the lexeme, which is the label."""
    written = list(with_attribute_tracks(tracks))
    names = {track.name for track in written}
    asked = [f"phrases.{name}" for name in sorted(PHRASE_ATTRIBUTES - {"lexeme", "tag"})]
    empty = [Track(name, ()) for name in asked if name not in names]
    return write_elan([row for track in (*written, *empty) for row in rows_of(track)])


def _mix(arguments: argparse.Namespace, log: Log) -> None:
    require_writable(arguments.output, field="output")
    if not 0 <= arguments.share <= 1:
        message = f"share: {arguments.share:g}; give 0 (all of the first) to 1 (all of the second)"
        raise InputError("value_wrong", message, field="share")
    one, other = map(named_profile, arguments.profiles)
    mixed = mix(one, other, arguments.share, name=_name(arguments.output, arguments.profiles))
    write(arguments.output, profile_yaml(mixed))
    log.note("\n".join(profile_lines(mixed)))


def _list(_arguments: argparse.Namespace, _log: Log) -> None:
    profiles = map(named_profile, profile_names())
    write_standard("".join(f"{each.name:16s} {each.description}\n" for each in profiles).encode())


def _show(arguments: argparse.Namespace, _log: Log) -> None:
    write_standard("".join(f"{line}\n" for line in profile_lines(named_profile(arguments.name))).encode())


def _name(output: str, inputs: Sequence[str]) -> str:
    return PurePath(inputs[0] if output == STANDARD else output).stem
