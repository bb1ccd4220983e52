"""What planning needs, loaded once: the encoder, the weights of the choice, and the tables of authors."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

from ...model import SingleArray
from .authored_weights import TermNames, load_weights
from .choice_model import ChoiceModel
from .encoder import Encoder
from .families import Families, merged
from .mimes import MimeTable
from .terms import TermTable
from .worths import shown_by_lexemes


@dataclass(frozen=True, slots=True, eq=False)
class Planner:
    """The models of planning, loaded once: the encoder, the weights, how much each lexeme shows each family (L, F) with
    the lexemes' names, the lemmas without which a family cannot be shown (mimes: "drink", "phone"), and which verb is
    shown by which mime."""

    encoder: Encoder
    choice: ChoiceModel
    lexemes: Mapping[str, int]
    shown: SingleArray
    needed_lemmas: Mapping[str, frozenset[str]]
    mimes: MimeTable
    terms: TermTable
    kind_weights: Mapping[str, Mapping[str, float]]

    @classmethod
    def load(
        cls,
        folders: tuple[Path, Path],
        families: Families,
        predicates: Mapping[str, int],
        classes: Mapping[str, Collection[str]],
    ) -> "Planner":
        """Loads from the `folders` models/acting and lexicon/acting; `predicates` are those of the rules with their
        numbers of arguments, `classes` those of functions with their subtypes.

        Raises ServiceError `model_unreadable`, and AuthoringError for the weights and terms of authors.
        """
        models, lexicon = folders
        choice = ChoiceModel.load(models / "weights.json")
        table = TermTable.load(lexicon / "terms.yaml", predicates)
        names = TermNames.of(choice.terms, table.names.values(), classes)
        kinds = (*choice.head, *choice.face)
        authored = load_weights(lexicon / "weights.yaml", choice.families, names, kinds)
        return cls(
            encoder=Encoder.load(models / "encoder.onnx"),
            choice=choice.with_weights(authored),
            lexemes=MappingProxyType({lexeme: column for column, lexeme in enumerate(families.shows)}),
            shown=shown_by_lexemes(families.shows, choice.families),
            needed_lemmas=MappingProxyType(dict(_needed_lemmas(families))),
            mimes=MimeTable.load(lexicon / "mimes.yaml", families.gesture_names),
            terms=table,
            kind_weights=MappingProxyType(
                {term: {kind: by[kind] for kind in kinds if by.get(kind)} for term, by in authored.items()}
            ),
        )


def _needed_lemmas(families: Families) -> Iterator[tuple[str, frozenset[str]]]:
    for family, behaviors in families.gesture.items():
        if all(behavior.lemmas for behavior in behaviors):
            yield merged(family), frozenset[str]().union(*(behavior.lemmas for behavior in behaviors))
