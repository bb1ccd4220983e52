"""Makes gesture scripts of annotated recordings and of lines, for the benchmarks of this room."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from training.profiles.make_examples import unspoken_analyses
from understudy.behavior.reading.player import Player
from understudy.behavior.speaker_profiles import gesture_script, repertoire_of
from understudy.model import Level, Parse, Token, Utterance
from understudy.models import Understudy
from understudy.profiles.annotation.model import Annotation
from understudy.profiles.annotation.reading import read_annotations
from understudy.profiles.generation.candidates import Repertoire
from understudy.profiles.generation.generating import Speaker, generate
from understudy.profiles.generation.script import GestureScript
from understudy.profiles.learning.learner import learn
from understudy.profiles.profile import Profile

EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "speakers"


@dataclass(frozen=True, slots=True)
class AnnotatedSpeaker:
    """A speaker's annotation and the profile that is learnt from it."""

    annotation: Annotation
    profile: Profile

    @property
    def utterance(self) -> Utterance:
        """The words of the whole recording; a word's lemma is the word."""
        words = self.annotation.words
        tokens = [
            Token(word.index, word.index, word.text, word.text.strip(",.;:!?").lower(), "X", "X", "dep", 0)
            for word in words
        ]
        return Utterance(words, Parse(tuple(tokens), (), ()), duration_s=self.annotation.duration_s)


def example_speakers() -> tuple[AnnotatedSpeaker, AnnotatedSpeaker]:
    """The speakers of the repository, the one of large gestures first."""
    sweeping, sparing = read_annotations([EXAMPLES / "sweeping.json", EXAMPLES / "sparing.eaf"])
    return AnnotatedSpeaker(sweeping, learn([sweeping], "sweeping")), AnnotatedSpeaker(
        sparing, learn([sparing], "sparing")
    )


def default_repertoire(understudy: Understudy) -> Repertoire:
    """What the default character may play."""
    character = understudy.behavior.performers.named("default", Level.MEDIUM)
    return repertoire_of(Player(understudy.behavior.families, character.entries), character)


def annotated_scripts(
    speaker: AnnotatedSpeaker, repertoire: Repertoire, seeds: int, *, likeliest: bool = False
) -> Iterator[GestureScript]:
    """The words of an annotation in its speaker's way, once for each seed."""
    for seed in range(seeds):
        made = Speaker(speaker.profile, repertoire, seed, likeliest)
        yield generate(made, speaker.utterance, speaker.annotation.tags or ())


def line_scripts(
    understudy: Understudy, repertoire: Repertoire, profiles: Sequence[Profile], texts: Sequence[str]
) -> list[list[GestureScript]]:
    """The scripts of lines by each profile, the lines in the time of the clock."""
    analyses = unspoken_analyses(understudy, texts)
    return [
        [
            gesture_script(profile, repertoire, each.utterance, each.functions, seed=number)
            for number, each in enumerate(analyses)
        ]
        for profile in profiles
    ]
