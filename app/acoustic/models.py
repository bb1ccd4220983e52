"""The models of the acoustic stage, loaded once."""

from dataclasses import dataclass
from pathlib import Path
from typing import Self

from ..authored_folders import lexicon_folder
from ..files import resource_folder
from ..loading import OnDemand
from ..settings import Settings
from .affect.affect_model import AffectModel
from .affect.line_affect import AffectJudge, FeatureJudge
from .affect.waveform_model import WaveformModel
from .agitation.classifier import AgitationModel
from .alignment.aligner import Aligner
from .focus.focus_model import FocusModel
from .focus.listeners import Listeners
from .pacing.word_times import Pace


@dataclass(frozen=True, slots=True)
class AcousticModels:
    """The models of the acoustic stage (paper §3.1). With models of free data alone there is none of focus, and word
    times are the decoder's own, not refined. The aligner is loaded by the first line without word timings; it runs in a
    process of its own, which `close` (or a `with` block) ends."""

    settings: Settings
    when_aligning: OnDemand[Aligner]
    agitation: AgitationModel
    affect: AffectJudge
    listeners: Listeners
    focus: FocusModel | None
    when_pacing: OnDemand[Pace]

    @classmethod
    def load(cls, settings: Settings) -> "AcousticModels":
        """Loads all but the aligner; raises ServiceError when a model is missing or broken."""
        models, lexicon = resource_folder("models"), lexicon_folder()
        return cls(
            settings=settings,
            when_aligning=OnDemand(lambda: Aligner(models, lexicon / "en", refined=settings.model_data != "free")),
            agitation=_agitation_model(settings, models / "agitation"),
            affect=_affect_judge(settings, models / "affect"),
            listeners=Listeners.load(models / "focus" / "emphases.onnx"),
            focus=None if settings.model_data == "free" else FocusModel.load(models / "focus" / "focus.npz"),
            when_pacing=OnDemand(lambda: Pace.load(lexicon)),
        )

    @property
    def aligner(self) -> Aligner:
        """The aligner; on first use raises ServiceError when one of its models is missing or broken."""
        return self.when_aligning.get()

    def close(self) -> None:
        """Ends the aligner's process; the next line starts another."""
        aligner = self.when_aligning.made()
        if aligner is not None:
            aligner.close()

    def interrupt(self) -> None:
        """Ends what another thread is aligning; see `Aligner.interrupt`."""
        aligner = self.when_aligning.made()
        if aligner is not None:
            aligner.interrupt()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()


def _agitation_model(settings: Settings, folder: Path) -> AgitationModel:
    """The user's own model of agitation, else ours."""
    if settings.agitation_model is not None:
        return AgitationModel.load_file(settings.agitation_model)
    trained_on = folder / "free" if settings.model_data == "free" else folder
    return AgitationModel.load(trained_on, settings.agitation_features)


def _affect_judge(settings: Settings, folder: Path) -> AffectJudge:
    """The user's own model of affect, else ours."""
    if settings.affect_model is not None:
        return WaveformModel.load(settings.affect_model)
    return FeatureJudge(AffectModel.load(folder / f"{settings.model_data}.npz"))
