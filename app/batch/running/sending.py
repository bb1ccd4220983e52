"""Prepares jobs for workers on other machines: with the recordings in them, their outputs to be sent back."""

from concurrent.futures import Future
from dataclasses import replace

from ...errors import InputError
from ..work.jobs import Failure, LineJob, LineOutcome
from ..work.speaking import ReferenceJob


def sent(job: LineJob) -> LineJob:
    """The job with its recording. Raises InputError when that cannot be read."""
    return replace(job, audio=job.audio.to_send(), folder=None)


def voice_sent(job: ReferenceJob) -> ReferenceJob:
    """The job with its recordings. Those that cannot be read are left out; their own lines report why."""
    found = []
    for recording in job.recordings:
        try:
            found.append(recording.to_send())
        except InputError:
            continue
    return replace(job, recordings=tuple(found))


def failed_to_send(job: LineJob, error: InputError) -> "Future[LineOutcome]":
    """The outcome of a line whose recording cannot be read."""
    done: Future[LineOutcome] = Future()
    done.set_result(LineOutcome(job.id, 0.0, failure=Failure.of(error)))
    return done
