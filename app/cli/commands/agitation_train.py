"""`understudy agitation train`: trains the paper's classifier of agitation on labelled recordings, and reports its
accuracy on held-out speakers."""

import argparse
from pathlib import Path

import numpy as np

from ...acoustic.agitation.classifier import AgitationModel, save_file
from ...acoustic.agitation.teaching import LabelledRecordings, LeftOut, left_out, teach
from ...acoustic.agitation.utterance_features import FEATURE_SETS, full_features
from ...acoustic.agitation.voice_quality import voice_quality
from ...acoustic.signal.decoding import decode
from ...acoustic.stage import audio_limits, contours_of
from ...errors import InputError
from ...model import FloatArray, Level
from ...schemas.agitation_labels import LabelledRecording, read_labels
from ...settings import Settings, read_settings
from ..files import read_bytes, require_writable
from ..log import Log


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    require_writable(arguments.output, field="output")
    content = read_bytes(arguments.labels, limit=settings.max_body_bytes, field="labels")
    recordings = read_labels(content, Path(arguments.labels))
    feature_set = settings.agitation_features
    taught = _heard(recordings, feature_set, settings, log)
    log.stage("left out")
    told = left_out(taught, feature_set)
    log.stage("teach")
    model: AgitationModel = teach(taught, feature_set)
    save_file(model, Path(arguments.output))
    log.note(_told(told))
    return 0


def _heard(
    recordings: tuple[LabelledRecording, ...], feature_set: str, settings: Settings, log: Log
) -> LabelledRecordings:
    rows = []
    for number, each in enumerate(recordings, start=1):
        log.stage(f"hear {number}/{len(recordings)}")
        rows.append(_features(each.path, feature_set, settings))
    return LabelledRecordings(
        np.array(rows),
        np.array([each.memberships for each in recordings]),
        np.array([each.speaker for each in recordings]),
    )


def _features(path: Path, feature_set: str, settings: Settings) -> FloatArray:
    """Raises InputError with the recording's name."""
    content = read_bytes(str(path), limit=settings.max_audio_bytes, field="audio")
    try:
        audio = decode(content, audio_limits(settings))[0]
    except InputError as error:
        raise InputError(error.code, f"{path}: {error.message}", field="labels") from None
    contours = contours_of(audio)
    return full_features(contours, voice_quality(audio, contours.f0_hz))[: FEATURE_SETS[feature_set]]


def _told(found: LeftOut) -> str:
    shares = ", ".join(f"{level.value} {share:.2f}" for level, share in zip(Level, found.by_level, strict=True))
    judged = f"{found.by} left out: {found.balanced:.2f} right on average over levels ({shares}; chance .33)"
    voices = "1 speaker" if found.speakers == 1 else f"{found.speakers} speakers"
    warning = (
        "" if found.by == "speaker" else "\ntoo few speakers to leave one out: this says little about other speakers"
    )
    return f"{found.recordings} recordings of {voices}; each {judged}{warning}"
