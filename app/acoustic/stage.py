"""The acoustic stage: from a recording and its words to contours, agitation, and word times (paper §3.1)."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from ..authored_folders import lexicon_folder
from ..model import (
    Affect,
    Agitation,
    AlignedLine,
    Audio,
    Contours,
    Line,
    LineAffect,
    Manner,
    SignalAnalysis,
    StressThresholds,
    Timings,
    Word,
)
from ..model.voice.signal import SpeakerReference
from ..on_demand import OnDemand
from ..progress import Progress, no_progress
from ..resources import resource_folder
from ..settings import Settings
from ..transcript import read_transcript
from .affect.affect_model import AffectModel
from .affect.line_affect import AffectJudge, FeatureJudge, Stretch, line_affect
from .affect.manner import word_manners
from .affect.waveform_model import WaveformModel
from .agitation.agitation import AgitationModel
from .agitation.voice_quality import voice_quality
from .alignment.alignment import Aligner, Alignment
from .alignment.timings import read_fillers, read_timings
from .contours import contours_of
from .focus.focus import FocusModel
from .focus.listeners import Listeners
from .pacing.pacing import Pace
from .signal.background import doubts
from .signal.decoding import AudioLimits, decode
from .stress.prominence import prominence, with_listeners
from .stress.stress import Measure, stress, with_emphasis


@dataclass(frozen=True, slots=True)
class AcousticModels:
    """The models of the acoustic stage (paper §3.1). The aligner is loaded by the first line without word timings; it
    runs in a process of its own, which `close` (or a `with` block) ends."""

    settings: Settings
    when_aligning: OnDemand[Aligner]
    agitation: AgitationModel
    affect: AffectJudge
    listeners: Listeners
    focus: FocusModel
    when_pacing: OnDemand[Pace]

    @classmethod
    def load(cls, settings: Settings) -> "AcousticModels":
        """Loads all but the aligner; raises ServiceError when a model is missing or broken."""
        models, lexicon = resource_folder("models"), lexicon_folder()
        return cls(
            settings=settings,
            when_aligning=OnDemand(lambda: Aligner(models, lexicon / "en")),
            agitation=_agitation_model(settings, models / "agitation"),
            affect=_affect_judge(settings, models / "affect"),
            listeners=Listeners.load(models / "focus" / "emphases.onnx"),
            focus=FocusModel.load(models / "focus" / "focus.npz"),
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

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()


def _agitation_model(settings: Settings, folder: Path) -> AgitationModel:
    """The user's own model of agitation, else ours."""
    if settings.agitation_model is not None:
        return AgitationModel.load_file(settings.agitation_model)
    return AgitationModel.load(folder, settings.agitation_features)


def _affect_judge(settings: Settings, folder: Path) -> AffectJudge:
    """The user's own model of affect, else ours."""
    if settings.affect_model is not None:
        return WaveformModel.load(settings.affect_model)
    return FeatureJudge(AffectModel.load(folder / f"{settings.affect_data}.npz"))


def analyze_signal(
    acoustic: AcousticModels,
    audio: bytes,
    progress: Progress = no_progress,
    *,
    reference: SpeakerReference | None = None,
) -> SignalAnalysis:
    """Measures the signal alone: its contours, the speaker's agitation (paper §3.1.1 to §3.1.4) and feeling."""
    progress("decode")
    signal, notices = decode(audio, audio_limits(acoustic.settings))
    progress("contours")
    contours = contours_of(signal)
    progress("agitation")
    stretch = Stretch(signal, contours, voice_quality(signal, contours.f0_hz))
    agitation = acoustic.agitation.agitation(contours, stretch.quality, reference)
    affect = acoustic.affect.affect_of(stretch, reference)
    return SignalAnalysis(signal, contours, stretch.quality, agitation, affect, notices + doubts(contours.energy_db))


def hear_affect(
    acoustic: AcousticModels, heard: SignalAnalysis, words: tuple[Word, ...], reference: SpeakerReference | None = None
) -> LineAffect:
    """The feeling of the line and of each phrase of the timed words."""
    return line_affect(acoustic.affect, _stretch(heard), heard.affect, words, reference)


def hear_sound(acoustic: AcousticModels, sound: Audio) -> Affect:
    """The feeling of a sound that is heard as it comes."""
    contours = contours_of(sound)
    return acoustic.affect.affect_of(Stretch(sound, contours, voice_quality(sound, contours.f0_hz)))


def hear_manners(
    heard: SignalAnalysis, words: tuple[Word, ...], agitation: Agitation, affect: LineAffect
) -> tuple[Manner, ...]:
    """How a movement is made on each of the timed words, by the voice there."""
    return word_manners(_stretch(heard), words, agitation, affect)


def _stretch(heard: SignalAnalysis) -> Stretch:
    return Stretch(heard.audio, heard.contours, heard.quality)


def align_words(
    acoustic: AcousticModels,
    audio: Audio,
    transcript: tuple[Word, ...],
    timings: Timings | None = None,
) -> Alignment:
    """The words with the times that the caller gave, else with the aligner's."""
    if timings is None:
        return acoustic.aligner.listen(audio, transcript)
    words = read_timings(timings.content, timings.format, transcript, duration_s=audio.duration_s)
    return Alignment(words, (), read_fillers(timings.content, timings.format, duration_s=audio.duration_s))


def measure_stress(
    acoustic: AcousticModels, words: tuple[Word, ...], contours: Contours, audio: Audio | None = None
) -> tuple[tuple[Word, ...], StressThresholds]:
    """Timed words with their stress, prominence, emphasis and focus, and the utterance's own thresholds (paper §3.1.5).
    Prominence and focus are surer with the recording itself."""
    listeners = acoustic.listeners.heard(audio, words) if audio else {}
    stressed, thresholds = stress(with_listeners(prominence(words, contours), listeners), contours)
    settings = acoustic.settings
    measure = Measure(settings.emphasis)
    focused = acoustic.focus.with_focus(stressed, contours, listeners)
    return with_emphasis(focused, measure), thresholds


def make_reference(acoustic: AcousticModels, recordings: Sequence[SignalAnalysis]) -> SpeakerReference:
    """How the speaker of these recordings, one or more, usually sounds."""
    features = [acoustic.agitation.describe(heard.contours, heard.quality) for heard in recordings]
    return SpeakerReference.of(acoustic.agitation.feature_set, features)


def align(acoustic: AcousticModels, line: Line) -> AlignedLine:
    """The times of the words and phones of a line."""
    transcript = read_transcript(line.text, max_characters=acoustic.settings.max_text_characters)
    signal, notices = decode(line.recording, audio_limits(acoustic.settings))
    timed = align_words(acoustic, signal, transcript, line.timings)
    return AlignedLine(timed.words, signal.duration_s, notices + timed.notices, timed.fillers)


def audio_limits(settings: Settings) -> AudioLimits:
    """The limits that the settings put on audio."""
    return AudioLimits(max_duration_s=settings.max_audio_s, max_bytes=settings.max_audio_bytes)
