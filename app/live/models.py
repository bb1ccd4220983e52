"""The models of live speech, loaded once and shared by all streams."""

from dataclasses import dataclass
from typing import Self

from ..acoustic.pacing.phone_durations import FILE as DURATIONS
from ..acoustic.pacing.phone_durations import PhoneDurations
from ..authored_folders import lexicon_folder
from ..files import resource_folder
from ..models import Understudy
from ..motion_models.model import MotionModel
from ..prosody_gestures.voice_model import VoiceModel
from .mouth import MouthModel
from .table import FILE as LIVE
from .table import LiveTable


@dataclass(frozen=True, slots=True, eq=False)
class LiveModels:
    """The whole understudy, for words and bodies, and the models of gestures and mouth from the voice alone."""

    understudy: Understudy
    voice: VoiceModel
    mouth: MouthModel
    table: LiveTable
    durations: PhoneDurations
    motion: MotionModel | None = None

    @classmethod
    def load(cls, understudy: Understudy) -> Self:
        """Raises ServiceError `model_unreadable`, AuthoringError for `lexicon/live.yaml` and
        `phone_durations.yaml`."""
        models, lexicon = resource_folder("models"), lexicon_folder()
        return cls(
            understudy,
            VoiceModel.load(models / "prosody_gestures" / "voice.npz"),
            MouthModel.load(models / "live" / "mouth.npz"),
            LiveTable.load(lexicon / LIVE, understudy.behavior.characters.behavior_names),
            PhoneDurations.load(lexicon / DURATIONS),
        )
