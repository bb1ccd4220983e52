"""Learns how a speaker usually sounds, from recordings of the batch itself."""

from collections.abc import Iterator
from dataclasses import dataclass

from ...errors import InputError
from ...library.hearing import AcousticModels, analyze_signal, make_reference
from ...model import SignalAnalysis
from ...model.voice.signal import SpeakerReference
from .audio import AudioSource


@dataclass(frozen=True, slots=True)
class ReferenceJob:
    """A speaker whose usual voice is to be learnt, with recordings."""

    speaker: str
    recordings: tuple[AudioSource, ...]


def learn_reference(job: ReferenceJob, acoustic: AcousticModels) -> SpeakerReference | None:
    """The reference; recordings that cannot be analysed are left out (their own lines report why), None if none can."""
    heard = list(_heard(job, acoustic))
    return make_reference(acoustic, heard) if heard else None


def _heard(job: ReferenceJob, acoustic: AcousticModels) -> Iterator[SignalAnalysis]:
    for recording in job.recordings:
        try:
            yield analyze_signal(acoustic, recording.content())
        except InputError:
            continue
