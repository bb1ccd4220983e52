"""Learns a gesture profile from annotated recordings; words that an annotation does not tag are tagged by the rules."""

from collections.abc import Sequence
from dataclasses import replace

from ..loading import OnDemand
from ..models import LanguageModels
from ..profiles.annotation.model import Annotation, TaggedWords
from ..profiles.learning.learner import learn
from ..profiles.profile import Profile, tags_of
from ..rules.stage import find_functions_in_all


def learn_profile(
    language: OnDemand[LanguageModels], annotations: Sequence[Annotation], name: str, description: str = ""
) -> Profile:
    """The profile of the one speaker of these annotations.

    The language models are loaded only if an annotation has no tags. Raises InputError `too_few_gestures`.
    """
    tagged = [each if each.tags is not None else with_tags(language.get(), each) for each in annotations]
    return learn(tagged, name, description)


def with_tags(language: LanguageModels, annotation: Annotation) -> Annotation:
    """The annotation, its words tagged with the communicative functions of each segment."""
    spans = annotation.segments
    segments = [annotation.words[first : last + 1] for first, last in spans]
    renumbered = [tuple(replace(word, index=place) for place, word in enumerate(words)) for words in segments]
    found = find_functions_in_all(language, renumbered)
    tags = [
        TaggedWords(each.tag, first + each.first, first + each.last)
        for (first, _last), analysis in zip(spans, found, strict=True)
        for each in tags_of(analysis.functions)
    ]
    return replace(annotation, tags=tuple(tags))
