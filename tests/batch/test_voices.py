"""Which voices are learnt, from which recordings, and that the result is kept."""

from pathlib import Path

import numpy as np

from understudy.batch.audio import AudioSource
from understudy.batch.voices import (
    FEWEST_RECORDINGS,
    MOST_RECORDINGS,
    keep_learnt,
    read_learnt,
    reference_jobs,
)
from understudy.model.voice.signal import SpeakerReference


def recordings(speaker: str, count: int) -> list[tuple[str, AudioSource]]:
    return [(speaker, AudioSource(Path(f"{speaker.lower()}{number:03}.wav"))) for number in range(count)]


def test_speakers_with_recordings_enough_are_learnt_from_some_of_all() -> None:
    found = [*recordings("ANN", 3), *recordings("Ann", 97), *recordings("Ben", FEWEST_RECORDINGS - 1)]
    (job,) = reference_jobs(found)
    assert job.speaker == "ann"
    assert len(set(job.recordings)) == MOST_RECORDINGS
    assert (job.recordings[0], job.recordings[-1].path.name) == (found[0][1], "ann092.wav")


def test_what_was_learnt_is_kept(tmp_path: Path) -> None:
    jobs = reference_jobs([*recordings("Ann/1", 5), *recordings("Ben", 5)])
    assert read_learnt(tmp_path, jobs) == {}
    keep_learnt(tmp_path, jobs[0].speaker, SpeakerReference("full", 5, np.array([0.5, 1.0]), np.array([1.0, 2.0])))
    learnt = read_learnt(tmp_path, jobs)
    assert list(learnt) == ["ann_1"]
    assert learnt["ann_1"].mean.tolist() == [0.5, 1.0]
