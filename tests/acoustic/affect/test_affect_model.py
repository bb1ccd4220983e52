"""The mixture of experts: whose recordings an utterance is like decides, and what is strange is neutral."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.support.words.measured import stretch_of
from understudy.acoustic.affect.affect_model import AffectModel, Expert, Gate, KernelMachines
from understudy.acoustic.agitation.classifier import FuzzySvm
from understudy.acoustic.agitation.utterance_features import TypicalSpeaker
from understudy.errors import InputError, ServiceError
from understudy.files import resource_folder
from understudy.model import NEUTRAL, SAMPLE_RATE_HZ, Audio, FloatArray, Tone
from understudy.model.voice.signal import SpeakerReference

SHIPPED = resource_folder("models") / "affect"


def machines(second: float) -> KernelMachines:
    """Two tones, the first where the first feature is -1, the second where it is +1; the first dimension is `second`
    there."""
    svm = FuzzySvm(
        mean=np.zeros(2),
        scale=np.ones(2),
        gamma=np.array([1.0]),
        support_vectors=np.array([[-1.0, 0.0], [1.0, 0.0]]),
        coefficients=2 * np.eye(2),
        intercepts=-np.ones(2),
        slopes=3 * np.ones(2),
        offsets=np.zeros(2),
    )
    return KernelMachines(svm, np.array([[0.0, 0.0, 0.0], [second, 0.0, 0.0]]), np.zeros(3))


def expert(corpus: str, tone: Tone, activation: float) -> Expert:
    return Expert(corpus, (Tone.NEUTRAL, tone), machines(activation), machines(-activation))


def model(gate: float = 50.0) -> AffectModel:
    """Two experts; the second feature tells which of them is asked."""
    return AffectModel(
        TypicalSpeaker(np.zeros(2), np.ones(2)),
        Gate(np.zeros(2), np.ones(2), np.array([[0.0, 0.0], [-gate, gate]]), np.zeros(2)),
        (expert("one", Tone.ANGRY, 0.5), expert("other", Tone.SAD, -0.5)),
        familiar=4.0,
    )


def at(first: float, second: float) -> FloatArray:
    return np.array([first, second])


@pytest.mark.parametrize(
    ("place", "tone"), [(at(1, -0.5), Tone.ANGRY), (at(1, 0.5), Tone.SAD), (at(-1, 0.5), Tone.NEUTRAL)]
)
def test_the_expert_of_the_nearest_corpus_decides(place: FloatArray, tone: Tone) -> None:
    affect = model().affect(place)
    assert affect.tone is tone
    assert sum(affect.tones) == pytest.approx(1)


def test_between_two_corpora_both_are_heard() -> None:
    affect = model().affect(at(1, 0))
    assert affect.share(Tone.ANGRY) == pytest.approx(affect.share(Tone.SAD))
    assert affect.activation == pytest.approx(0, abs=1e-6)


def test_what_is_unlike_all_recordings_is_neutral() -> None:
    assert model().affect(at(30, 30)) == NEUTRAL


def test_unknown_features_are_average() -> None:
    assert model().affect(np.array([1.0, np.nan])) == model().affect(at(1, 0))


def test_a_reference_of_many_recordings_is_trusted() -> None:
    reference = SpeakerReference("full", 10_000, np.zeros(2), np.ones(2))
    assert model().affect(at(1, -0.5)).activation > 0
    assert model().affect(at(1, -0.5), reference).activation < 0


def test_a_reference_for_the_agitation_alone_changes_nothing() -> None:
    reference = SpeakerReference("paper", 10, np.zeros(12), np.ones(12))
    assert model().affect(at(1, 0), reference) == model().affect(at(1, 0))


def test_a_reference_of_other_features_is_refused() -> None:
    with pytest.raises(InputError) as raised:
        model().affect(at(1, 0), SpeakerReference("full", 10, np.zeros(3), np.ones(3)))
    assert raised.value.code == "reference_other_features"


def test_what_is_saved_is_loaded(tmp_path: Path) -> None:
    model().save(tmp_path / "own.npz")
    loaded = AffectModel.load(tmp_path / "own.npz")
    place = at(0.7, 0.1)
    assert loaded.affect(place).tones == pytest.approx(model().affect(place).tones, abs=1e-6)
    assert [each.tones for each in loaded.experts] == [each.tones for each in model().experts]


def test_a_file_without_the_gate_is_no_model(tmp_path: Path) -> None:
    model().save(tmp_path / "own.npz")
    (tmp_path / "own.npz.sha256").unlink()
    with pytest.raises(ServiceError) as raised:
        AffectModel.load(tmp_path / "own.npz")
    assert raised.value.code == "model_unreadable"


@pytest.mark.parametrize("name", ["all", "free"])
@pytest.mark.parametrize("samples", [np.zeros(1), np.zeros(SAMPLE_RATE_HZ), np.eye(1, 400)[0]])
def test_the_shipped_models_judge_whatever_they_hear(name: str, samples: FloatArray) -> None:
    affect = AffectModel.load(SHIPPED / f"{name}.npz").affect(stretch_of(Audio(samples)).features())
    assert sum(affect.tones) == pytest.approx(1)
    assert all(-1 <= value <= 1 for value in (affect.activation, affect.valence, affect.dominance))


def test_recording_level_changes_nothing() -> None:
    shipped = AffectModel.load(SHIPPED / "all.npz")
    noise = np.random.default_rng(0).normal(0, 0.1, SAMPLE_RATE_HZ) * np.hanning(SAMPLE_RATE_HZ)
    loud, quiet = (shipped.affect(stretch_of(Audio(noise * gain)).features()) for gain in (1.0, 0.05))
    assert loud.tones == pytest.approx(quiet.tones, abs=1e-3)


def test_familiarity_has_no_say_within_its_bound() -> None:
    strict = replace(model(), familiar=0.4)
    assert strict.affect(at(0.5, 0.1)) == model().affect(at(0.5, 0.1))
