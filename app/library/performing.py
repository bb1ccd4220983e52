"""From a recorded line to its performance (paper §3, Figure 2)."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal, TypedDict, Unpack

from ..model import Analysis, Direction, GivenFunction, Mode, Performance, Timings
from ..model.edits import NO_EDITS, Edits
from ..model.voice.signal import SpeakerReference
from ..models import Understudy
from ..options import Options
from ..performance import PerformedLine, perform_analysis, perform_line
from ..performance import analyze as analyze_line
from ..performance import perform as _perform
from ..schemas.options import check_options
from ..schemas.requests import spoken_line
from ..settings import Settings, read_settings
from .sources import AffectName, FileSource, LevelName, content_of, line_of, timings_of

__all__ = [
    "PerformKeywords",
    "PerformedLine",
    "analyze",
    "analyze_line",
    "load",
    "perform",
    "perform_analysis",
    "perform_line",
    "say",
]


class PerformKeywords(TypedDict, total=False):
    """How a line is to be performed; for what is left out, the defaults of `Options` hold.

    `character` names the performer (lexicon/characters), `agitation` overrides the measured level, `affect` the feeling
    that is heard: a tone, activation, valence and dominance (-1 to 1), or rows of a time and these; `seed` draws
    other takes among movements that are nearly as good, `choice` is `terms` or the paper's `priority`, `mode` says
    where gestures come from, `listener` has the names of the listeners, and `reference` is how the speaker usually
    sounds (`make_reference`). The performance begins `lead_in_s` (0 to 3) before the recording; `stillness` (0 to 1)
    reduces all movement. `targets` are the positions of things and listeners, [x, y, z] in metres by name: Y up, the
    character at the origin facing +Z, its left +X. `profile` names a
    gesture profile (docs/profiles.md).
    """

    character: str
    agitation: LevelName | None
    affect: AffectName | Sequence[float] | Sequence[Sequence[float]] | None
    seed: int
    choice: Literal["terms", "priority"] | None
    mode: Mode | Literal["semantic", "prosody", "random"]
    listener: Sequence[str]
    reference: SpeakerReference | None
    lead_in_s: float
    stillness: float
    targets: Mapping[str, Sequence[float]]
    profile: str | None


def load(settings: Settings | None = None, *, lexicon: Sequence[str | os.PathLike[str]] = ()) -> Understudy:
    """Loads models, rules, words and gestures, which takes seconds; threads may share them. Use the result in a `with`
    block, or `close` it: the aligner has a process of its own.

    `lexicon` are an author's folders of words, rules, gestures, characters and profiles, laid over the bundled ones
    (docs/authoring.md) besides those of the settings.

    Without `settings` those of the environment hold (docs/settings.md). Raises InputError `setting_wrong`,
    AuthoringError with every mistake in rules, words and gestures, ServiceError for a model that does not load.
    """
    settings = settings or read_settings()
    folders = (*settings.lexicon_folders, *map(Path, lexicon))
    return Understudy.load(settings.model_copy(update={"lexicon": os.pathsep.join(map(str, folders)) or None}))


def perform(
    models: Understudy,
    audio: FileSource,
    text: str,
    *,
    words: FileSource | Timings | None = None,
    functions: Sequence[GivenFunction] = (),
    direction: Direction | None = None,
    edits: FileSource | Edits = NO_EDITS,
    **options: Unpack[PerformKeywords],
) -> Performance:
    """The performance of a recorded line, with the reason for each movement (Marsella et al. 2013, §3).

    `audio` is a WAV, FLAC or OGG file, `text` what is said in it. `words` are timings made elsewhere (the name of a
    .json, .TextGrid or .ctm file, or `Timings`), which replace the alignment. `functions` are communicative functions
    that the caller already knows, `direction` is a director's notes (docs/directing.md), `edits` are an author's
    changes (docs/edits.md). Raises InputError for input that cannot be used.
    """
    fields: dict[str, Any] = {**options}
    reference = fields.pop("reference", None)
    line = replace(line_of(audio, text, words, functions), direction=direction)
    return _perform(models, line, replace(check_options(fields), reference=reference).with_edits(_edits(edits)))


def say(
    models: Understudy,
    text: str,
    *,
    words: FileSource | Timings | None = None,
    functions: Sequence[GivenFunction] = (),
    direction: Direction | None = None,
    edits: FileSource | Edits = NO_EDITS,
    **options: Unpack[PerformKeywords],
) -> Performance:
    """The performance of a line without a recording, timed as it is usually spoken (Hartmann, Mancini & Pelachaud 2002,
    §5, with a synthesizer's times in `words`).

    `text` may mark *emphasis*, or be XML with the tags of SSML, APML and our own (docs/say.md). The other arguments are
    those of `perform`; agitation is medium and the feeling neutral unless given. Raises InputError as `perform` does,
    and `tags_wrong`.
    """
    fields: dict[str, Any] = {**options}
    reference = fields.pop("reference", None)
    line = spoken_line(text, timings_of(words), tuple(functions), direction)
    return _perform(models, line, replace(check_options(fields), reference=reference).with_edits(_edits(edits)))


def analyze(
    models: Understudy,
    audio: FileSource,
    text: str,
    *,
    words: FileSource | Timings | None = None,
    functions: Sequence[GivenFunction] = (),
    reference: SpeakerReference | None = None,
) -> Analysis:
    """The analysis of a line before any movement is chosen: prosody, words, communicative functions (§3.1 to §3.3).
    Arguments and errors are those of `perform`."""
    return analyze_line(models, line_of(audio, text, words, functions), Options(reference=reference))


def _edits(given: FileSource | Edits) -> Edits:
    """The edits, read if they are a file; raises InputError for what cannot be read."""
    if isinstance(given, Edits):
        return given
    from ..schemas.edits import read_edits

    return read_edits(content_of(given))
