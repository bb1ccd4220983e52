"""Hashes of everything a line is made from: while they are the same, it need not be performed again."""

import hashlib
import json
from dataclasses import dataclass, replace
from pathlib import Path

from ...authored_folders import lexicon_folder, rules_folder
from ...files import resource_folder
from ...model.edits import NO_EDITS
from ...model.voice.signal import SpeakerReference
from ...settings import Settings
from ...version import __version__
from ..work.jobs import LineJob, MotionForm

DIGEST_BYTES = 16
_CHUNK_BYTES = 1 << 20
_OF_THE_RESULT = frozenset(
    {
        "parser",
        "emphasis",
        "agitation_features",
        "agitation_model",
        "model_data",
        "affect_model",
        "choice",
        "max_audio_s",
        "part_bytes",
    }
)
"""Settings that affect a performance, or whether there is one."""


@dataclass(frozen=True, slots=True)
class KnownRecording:
    """The hash of a recording's content, with the file's size and modification time when it was read."""

    size: int
    modified_ns: int
    hash: str

    @classmethod
    def of(cls, path: Path, known: "KnownRecording | None" = None) -> "KnownRecording":
        """The known hash if the file has not changed, else a new one; raises OSError."""
        status = path.stat()
        if known is not None and (known.size, known.modified_ns) == (status.st_size, status.st_mtime_ns):
            return known
        digest = hashlib.blake2b(digest_size=DIGEST_BYTES)
        with path.open("rb") as file:
            while chunk := file.read(_CHUNK_BYTES):
                digest.update(chunk)
        return cls(status.st_size, status.st_mtime_ns, digest.hexdigest())


def input_hash(job: LineJob, recording: str) -> str:
    """A hash of a line's own input; `recording` is the hash of its recording's file."""
    options = job.options
    return _digest(
        recording,
        repr(job.audio.interval),
        job.text,
        repr(job.direction),
        repr((options.character, options.agitation, options.seed, options.stillness, options.played_by)),
        repr(options.targets),
        _reference(options.reference),
        repr([target.path for target in job.targets]),
        *([] if options.choice is None else [options.choice]),
        *([] if options.affect is None else [repr(options.affect)]),
        *([] if options.profile is None else [repr(options.profile)]),
        *([] if not options.listener_profiles else [repr(options.listener_profiles)]),
        *([] if options.edits == NO_EDITS else [repr(options.edits)]),
    )


def settings_hash(job: LineJob, settings: Settings, installation: str) -> str:
    """A hash of what all lines have in common; `installation` is `installation_hash()`."""
    options, motion = job.options, job.motion
    return _digest(
        installation,
        settings.model_dump_json(include=set(_OF_THE_RESULT)),
        repr((options.mode, replace(options.form, audio_file=None), options.lead_in_s)),
        repr([target.form.value for target in job.targets]),
        repr(motion if motion != MotionForm() else None),
    )


def installation_hash() -> str:
    """A hash of the version, the rules, words and characters, and the models."""
    digest = hashlib.blake2b(__version__.encode(), digest_size=DIGEST_BYTES)
    for folder in (rules_folder(), lexicon_folder(), resource_folder("models")):
        for path in sorted(path for path in folder.rglob("*") if path.is_file() and path.suffix not in {".py", ".pyc"}):
            digest.update(path.relative_to(folder).as_posix().encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def _reference(reference: SpeakerReference | None) -> str:
    if reference is None:
        return ""
    numbers = [reference.mean.tolist(), reference.deviation.tolist()]
    return json.dumps([reference.feature_set, reference.recordings, numbers])


def _digest(*parts: str) -> str:
    return hashlib.blake2b("\0".join(parts).encode(), digest_size=DIGEST_BYTES).hexdigest()
