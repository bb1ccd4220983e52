"""Learns how the batch's speakers usually sound, from their recordings in it.

The result is kept in `OUT/references/NAME.json`, in the format of `understudy reference`, and not learnt again when
recordings are added: otherwise every new take would change all lines of its speaker. Delete a file to have it learnt
again.
"""

from collections.abc import Iterable, Sequence
from pathlib import Path

from ..model.voice.signal import SpeakerReference
from ..schemas.references import read_reference, to_json
from .audio import AudioSource
from .layout import file_name
from .work.files import write_whole
from .work.jobs import ReferenceJob

FOLDER = "references"

FEWEST_RECORDINGS = 4
"""With fewer recordings a speaker has no reference: what they have in common may be the mood."""

MOST_RECORDINGS = 24
"""More add little: the average speaker counts as 3 recordings in the mean (`SpeakerModel`)."""


def reference_jobs(recordings: Iterable[tuple[str, AudioSource]]) -> tuple[ReferenceJob, ...]:
    """A job for each speaker with enough recordings; of too many, evenly spaced ones are taken."""
    by_speaker: dict[str, list[AudioSource]] = {}
    for speaker, recording in recordings:
        by_speaker.setdefault(speaker_of(speaker), []).append(recording)
    return tuple(
        ReferenceJob(speaker, _evenly(found))
        for speaker, found in sorted(by_speaker.items())
        if len(found) >= FEWEST_RECORDINGS
    )


def speaker_of(character: str) -> str:
    """The name of the speaker whose voice is learnt for a script's character; also the file name."""
    return file_name(character).casefold()


def read_learnt(out: Path, jobs: Sequence[ReferenceJob]) -> dict[str, SpeakerReference]:
    """The references learnt before, by speaker; raises InputError `reference_unreadable`."""
    paths = {job.speaker: _path(out, job.speaker) for job in jobs}
    return {speaker: read_reference(path.read_bytes(), str(path)) for speaker, path in paths.items() if path.is_file()}


def keep_learnt(out: Path, speaker: str, reference: SpeakerReference) -> None:
    """Writes a learnt reference; raises OSError."""
    write_whole(out, _path(out, speaker).relative_to(out).as_posix(), to_json(reference))


def _path(out: Path, speaker: str) -> Path:
    return out / FOLDER / f"{speaker}.json"


def _evenly(recordings: Sequence[AudioSource]) -> tuple[AudioSource, ...]:
    count = min(len(recordings), MOST_RECORDINGS)
    return tuple(recordings[place * len(recordings) // count] for place in range(count))
