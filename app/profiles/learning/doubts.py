"""What a person should know of a profile that was learnt: that there was little to learn from, or that something said
nothing."""

from collections.abc import Collection, Iterator, Sequence

from ...model import Notice
from ..annotation.model import Annotation
from ..profile import Profile

FEW_GESTURES = 100
"""Of the examples' gestures, any 25 on end have lexemes of which a quarter would have to be moved to be those of all,
50 an eighth, 100 one in twenty (`docs/measurements/profiles.md`). NGS had about 200 of each speaker, in nine
minutes."""


def doubts(profile: Profile, annotations: Sequence[Annotation], postures: Collection[str]) -> Iterator[Notice]:
    """The doubts about a profile that was learnt from these annotations; bodies have the `postures`."""
    for each in annotations:
        if each.unread:
            message = f"{each.path}: tracks that are not read: {', '.join(each.unread)}"
            yield Notice("annotation_tracks_unread", message)
    unknown = [each for each in profile.head.postures if each not in postures]
    if unknown:
        message = f"postures that no body takes: {', '.join(unknown)}; there are {', '.join(postures)}"
        yield Notice("annotation_postures_unknown", message)
    if profile.gestures < FEW_GESTURES:
        message = (
            f"{profile.gestures} gestures in {profile.annotated_s / 60:.1f} minutes of speech are few to know a speaker"
            " by: what is rare is guessed from what is common; annotate about nine minutes"
        )
        yield Notice("annotation_short", message)
    if profile.smoothing.held_out <= profile.smoothing.blind:
        message = "what is said tells nothing of which gesture comes: those that were held out came with any tag alike"
        yield Notice("profile_tags_tell_nothing", message)
