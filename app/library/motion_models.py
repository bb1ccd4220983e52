"""Motion from data: models learnt from recordings with motion, and motion made by them (docs/motion-models.md)."""

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

from ..acoustic.signal.decoding import decode
from ..acoustic.stage import audio_limits, contours_of
from ..errors import InputError, did_you_mean, shown
from ..files import resource_folder
from ..model import FRAME_SHIFT_S, AffectTrack, Analysis, Performance
from ..model.performance import Progress, no_progress
from ..models import Understudy
from ..motion_models.affect import LinearAffectModel
from ..motion_models.model import SCENARIOS, MotionModel, Scenario, is_model
from ..motion_models.pairs import SOUNDS, Pair, PairFile, Voice, heard_voice, read_pair
from ..motion_models.performing import laid_over, move, move_at_random, replaced_behaviors
from ..motion_models.playing import played
from ..motion_models.scoring import Correlation, Scores, left_out_trials, scored
from ..motion_models.training import Learning, learn
from ..prosody_gestures.semi_markov import FRAME_S
from ..prosody_gestures.trellis import EVERYTHING, Search
from ..realization import PreparedSchedule, RealizedSchedule, Realizer, realize_prepared
from ..realizer.body.motion import Motion
from ..realizer.body.skeleton import Skeleton
from ..schemas.affect import read_affect_track
from ..schemas.options import check_options, check_realize_options
from ..settings import Settings, read_settings
from .sources import AffectName, FileSource, content_of

__all__ = [
    "DEFAULT_MODEL",
    "DEFAULT_SCENARIO",
    "Correlation",
    "Learning",
    "MotionModel",
    "MotionSource",
    "Pair",
    "Scores",
    "Search",
    "motion_model_named",
    "moving_by",
    "moving_by_recording",
    "read_motion_model",
    "read_pairs",
    "realize_by_model",
    "realize_moving",
    "realize_played",
    "scenario_named",
    "score_motion_models",
    "train_motion_model",
]

DEFAULT_MODEL = "default"
"""The name of the model that is shipped: learnt from our own performances (models/motion)."""

DEFAULT_SCENARIO = "S1"
AFFECT = ".affect.csv"
MOST_MISTAKES = 20


@dataclass(frozen=True, slots=True, eq=False)
class MotionSource:
    """What moves a body by a model: the voice, the scenario (`SCENARIOS`), and how the best path is searched."""

    model: MotionModel
    voice: Voice
    scenario: Scenario
    search: Search = EVERYTHING


def train_motion_model(
    pairs: Sequence[Pair], *, kinds: int | None = None, seed: int = 0, progress: Progress = no_progress
) -> MotionModel:
    """The model of these recordings (`read_pairs`): phrases segmented from their motion, clustered into `kinds` (by
    default as many as keep the correlation with affect, AHG §4.1), and when a voice brings each.

    Raises InputError `pairs_wrong` where there is too little motion.
    """
    return learn(pairs, Learning(kinds, seed), progress).model


def read_pairs(
    folder: Path, realizer: Realizer, settings: Settings | None = None, progress: Progress = no_progress
) -> list[Pair]:
    """All recordings with motion in a folder, by name. Raises InputError `pairs_wrong` with every file that cannot be
    used, and why."""
    files, mistakes = _pair_files(folder)
    limits, estimator, pairs = audio_limits(settings or read_settings()), _estimator(), list[Pair]()
    for number, file in enumerate(files, start=1):
        progress(f"read {number}/{len(files)}")
        try:
            pairs.append(read_pair(file, realizer, estimator, limits))
        except InputError as error:
            mistakes.append(error.message)
    if mistakes:
        more = f"; and {len(mistakes) - MOST_MISTAKES} more" if len(mistakes) > MOST_MISTAKES else ""
        raise InputError("pairs_wrong", "; ".join(mistakes[:MOST_MISTAKES]) + more, field="folder")
    return pairs


def _pair_files(folder: Path) -> tuple[list[PairFile], list[str]]:
    """The recordings of a folder, and what is wrong with others."""
    if not folder.is_dir():
        raise InputError("pairs_wrong", f"{folder}: no folder", field="folder")
    files, mistakes = list[PairFile](), list[str]()
    for motion in sorted(path for path in folder.iterdir() if path.suffix in (".bvh", ".npz") and not is_model(path)):
        try:
            files.append(_pair_file(motion))
        except InputError as error:
            mistakes.append(error.message)
    if not files and not mistakes:
        has = ", ".join(path.name for path in sorted(folder.iterdir())[:5]) or "nothing"
        wanted = "give NAME.bvh with NAME.wav beside it, or NAME.npz (docs/motion-models.md)"
        raise InputError("pairs_wrong", f"{folder}: no recordings with motion, but {has}; {wanted}", field="folder")
    return files, mistakes


def _pair_file(motion: Path) -> PairFile:
    affect = motion.with_suffix(AFFECT)
    track = read_affect_track(affect.read_bytes(), str(affect)) if affect.exists() else None
    if motion.suffix == ".npz":
        return PairFile(motion, affect=track)
    sound = next((path for end in SOUNDS if (path := motion.with_suffix(end)).exists()), None)
    if sound is None:
        raise InputError("pairs_wrong", f"{motion}: no sound beside it; give {motion.stem}{SOUNDS[0]}")
    return PairFile(motion, sound, track)


def score_motion_models(
    pairs: Sequence[Pair],
    *,
    kinds: int | None = None,
    seed: int = 0,
    scenarios: Sequence[str] = tuple(SCENARIOS),
    searches: Sequence[Search] = (),
    progress: Progress = no_progress,
) -> Scores:
    """How near motion comes to the recorded one by models that were learnt without the session that they move (AHG §4),
    and how near each of the `searches` comes to the full one (RTS §3.1). Raises InputError `pairs_wrong`."""
    trials, left_out = left_out_trials(pairs, Learning(kinds, seed), progress)
    return scored(trials, left_out, scenarios, searches, progress)


def read_motion_model(path: str) -> MotionModel:
    """The model in a file, or the shipped one by the name `DEFAULT_MODEL`. Raises InputError `motion_model`."""
    if path == DEFAULT_MODEL:
        return MotionModel.load(_shipped())
    try:
        return MotionModel.load(Path(path))
    except OSError as error:
        message = f"{path}: cannot be read: {error.strerror}"
        raise InputError("motion_model", message, field="motion_model") from None


def motion_model_named(name: str, settings: Settings) -> MotionModel:
    """The shipped model, or that of an author's `motion/NAME.npz`, by its name. Raises InputError `motion_model`."""
    own = [path for folder in settings.lexicon_folders for path in sorted((folder / "motion").glob("*.npz"))]
    known = {DEFAULT_MODEL: _shipped(), **{path.stem: path for path in own}}
    if name not in known:
        message = f"no motion model is called {shown(name)}{did_you_mean(name, known)}; there are {', '.join(known)}"
        raise InputError("motion_model", message, field="motion_model")
    return MotionModel.load(known[name])


def _shipped() -> Path:
    return resource_folder("models") / "motion" / f"{DEFAULT_MODEL}.npz"


def scenario_named(name: str) -> Scenario:
    """Raises InputError `value_wrong`."""
    if name not in SCENARIOS:
        message = f"scenario: {shown(name)}; give one of {', '.join(SCENARIOS)}"
        raise InputError("value_wrong", message, field="scenario")
    return SCENARIOS[name]


def moving_by(
    model: MotionModel, analysis: Analysis, affect: AffectTrack | None, scenario: Scenario, search: Search = EVERYTHING
) -> MotionSource:
    """The motion of an analysed recording by a model; `affect` replaces the one estimated from the voice."""
    assert analysis.heard is not None, "a recording is heard"
    contours = analysis.heard.contours
    return MotionSource(model, heard_voice(contours.energy_db, contours.f0_hz, affect, _estimator()), scenario, search)


def moving_by_recording(
    model: MotionModel, audio: bytes, settings: Settings, scenario: Scenario, affect: AffectTrack | None = None
) -> MotionSource:
    """The motion of a recording that nobody has analysed by a model. Raises as the decoding of sound does."""
    sound, _ = decode(audio, audio_limits(settings))
    contours = contours_of(sound)
    return MotionSource(model, heard_voice(contours.energy_db, contours.f0_hz, affect, _estimator()), scenario)


def realize_by_model(
    models: Understudy,
    performance: Performance,
    audio: FileSource,
    *,
    model: FileSource = DEFAULT_MODEL,
    scenario: str = DEFAULT_SCENARIO,
    affect: AffectName | Sequence[float] | Sequence[Sequence[float]] | None = None,
    fps: Literal[30, 60] = 60,
    tail_s: float = 0.0,
) -> RealizedSchedule:
    """The motion of a performance whose arms, trunk and head move as in a motion model's recordings, driven by the
    voice in `audio` (docs/motion-models.md).

    `model` is what `understudy motion-model train` wrote, by name or content, or "default", the shipped one. `scenario`
    is S1 to S6 (AHG Table 1) or RTS; `affect` replaces the one estimated from the voice. Raises InputError
    `motion_model`, `value_wrong`, and as the decoding of sound does.
    """
    checked = check_realize_options({"fps": fps, "tail_s": tail_s})
    given: dict[str, Any] = {} if affect is None else {"affect": affect}
    learnt = MotionModel.read(model, "model") if isinstance(model, bytes) else read_motion_model(os.fspath(model))
    named, track = scenario_named(scenario), check_options(given).affect
    moving = moving_by_recording(learnt, content_of(audio), models.acoustic.settings, named, track)
    prepared = PreparedSchedule.of(performance)
    return realize_moving(models.realizer, prepared, moving, frame_rate_hz=checked.fps, tail_s=checked.tail_s)


def realize_moving(
    realizer: Realizer,
    prepared: PreparedSchedule,
    moving: MotionSource,
    *,
    frame_rate_hz: int = 60,
    tail_s: float = 0.0,
) -> RealizedSchedule:
    """The motion of a schedule whose arms, and whatever else the model has learnt, move as in its recordings."""

    def moved(motion: Motion, skeleton: Skeleton) -> Motion:
        return laid_over(motion, move(moving.model, moving.voice, moving.scenario, moving.search), skeleton)

    return _realized(realizer, prepared, moving.model, moved, frame_rate_hz=frame_rate_hz, tail_s=tail_s)


def realize_played(
    realizer: Realizer,
    prepared: PreparedSchedule,
    model: MotionModel,
    analysis: Analysis,
    *,
    drawn_by: int | None = None,
    frame_rate_hz: int = 60,
    tail_s: float = 0.0,
) -> RealizedSchedule:
    """The same as `understudy live --model` plays it, while the recording goes on; or, with a seed in `drawn_by`, by
    units that are drawn whatever is said (RTS §3.2)."""
    assert analysis.heard is not None, "a recording is heard"
    contours = analysis.heard.contours

    def moved(motion: Motion, skeleton: Skeleton) -> Motion:
        if drawn_by is None:
            return played(model, motion, contours, skeleton)
        frames = round(len(contours.energy_db) * FRAME_SHIFT_S / FRAME_S)
        return laid_over(motion, move_at_random(model, frames, drawn_by), skeleton)

    return _realized(realizer, prepared, model, moved, frame_rate_hz=frame_rate_hz, tail_s=tail_s)


def _realized(
    realizer: Realizer,
    prepared: PreparedSchedule,
    model: MotionModel,
    moved: Callable[[Motion, Skeleton], Motion],
    *,
    frame_rate_hz: int,
    tail_s: float,
) -> RealizedSchedule:
    """The schedule as it is realized otherwise, with the motion of a model in it."""
    schedule, told = replaced_behaviors(model, prepared.schedule)
    usual = realize_prepared(realizer, replace(prepared, schedule=schedule), frame_rate_hz=frame_rate_hz, tail_s=tail_s)
    motion = moved(usual.motion, realizer.performer(schedule.character).skeleton)
    return RealizedSchedule(schedule, replace(motion, decisions=(*motion.decisions, *told)))


def _estimator() -> LinearAffectModel:
    return LinearAffectModel.load(resource_folder("models") / "prosody_gestures" / "affect.npz")
