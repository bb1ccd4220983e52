"""Requests and responses about an author's rules: their files, the relations of one rule to others, and the effects of
edits."""

from collections.abc import Iterable, Mapping
from typing import Annotated, Self

from pydantic import BaseModel, ConfigDict, Field

from ..authoring.catalogue import Catalogue, Item, ItemKind
from ..authoring.rule_edits import LineChange
from ..authoring.saved_files import SavedText
from ..errors import Mistake
from .gestures.definitions import PlacedMistakeResponse
from .library import RuleResponse
from .line_parts import FunctionResponse
from .requests import checked, read_object
from .response_model import Number, ResponseModel

MOST_LINES = 500
MOST_RELATED = 200

Texts = Annotated[
    dict[str, str],
    Field(
        description="The whole text of each edited file, by its name.",
        examples=[{"lexicon/en/thanks.yaml": "class: thanks\ngroups:\n…"}],
    ),
]


class _Request(BaseModel):
    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid", strict=True)


class RuleEditsRequest(_Request):
    """Edited or new files; they apply to this request only."""

    files: Texts = {}


class RuleExplanationRequest(RuleEditsRequest):
    """A rule, behaviour or word to explain."""

    name: str


class RuleComparisonRequest(RuleEditsRequest):
    """Edited files, and the lines to try them on: texts by a name of the caller's, and all example lines."""

    lines: Annotated[dict[str, str], Field(json_schema_extra={"maxProperties": MOST_LINES})] = {}
    examples: bool = True


class RuleFileResponse(ResponseModel):
    """A file's text; `saved` says whether it is the author's own and not the one in use."""

    name: str
    text: str
    saved: bool

    @classmethod
    def of(cls, found: SavedText) -> Self:
        return cls.model_validate(found)


class RuleFilesResponse(ResponseModel):
    """The names of all files of a kind, of those that were saved, and whether files can be saved."""

    files: list[str]
    saved: list[str]
    writable: bool


class RuleCheckResponse(ResponseModel):
    """Every mistake in the files with the edits."""

    mistakes: list[PlacedMistakeResponse]

    @classmethod
    def of(cls, mistakes: Iterable[Mistake]) -> Self:
        return cls(mistakes=[PlacedMistakeResponse.of(each, file=str(each.path)) for each in mistakes])


class RuleExplanationResponse(RuleResponse):
    """An item with its author's comment and its text, and the items it depends on and leads to."""

    comment: str
    source: str
    comes_from: list[RuleResponse]
    leads_to: list[RuleResponse]

    @classmethod
    def of(cls, catalogue: Catalogue, item: Item) -> Self:
        shown = {name: getattr(item, name) for name in ("kind", "name", "class_name", "subtype", "file", "line")}
        return cls(
            **shown,
            comment=item.comment,
            source=item.source,
            comes_from=_listed(catalogue.that_lead_to(item)),
            leads_to=_listed(catalogue.that_follow(item)),
        )


class RuleExplanationsResponse(ResponseModel):
    """All items of that name."""

    items: list[RuleExplanationResponse]

    @classmethod
    def of(cls, catalogue: Catalogue, name: str) -> Self:
        """Raises InputError `unknown_name`."""
        return cls(items=[RuleExplanationResponse.of(catalogue, item) for item in catalogue.named(name)])


class OfferResponse(ResponseModel):
    """A behaviour that a rule offers for a function of these words, and its weight."""

    name: str
    rule: str
    class_name: str = Field(serialization_alias="class")
    first: int
    last: int
    weight: Number


class LineChangeResponse(ResponseModel):
    """A line for which something changed: the functions and offers that are gone, and the new ones."""

    id: str
    text: str
    functions_before: list[FunctionResponse]
    functions_after: list[FunctionResponse]
    offers_before: list[OfferResponse]
    offers_after: list[OfferResponse]

    @classmethod
    def of(cls, change: LineChange) -> Self:
        before, after = (
            [FunctionResponse.of(function, change.words) for function in functions]
            for functions in (change.functions_before, change.functions_after)
        )
        return cls(
            id=change.id,
            text=" ".join(word.text for word in change.words),
            functions_before=before,
            functions_after=after,
            offers_before=[OfferResponse.model_validate(offer) for offer in change.offers_before],
            offers_after=[OfferResponse.model_validate(offer) for offer in change.offers_after],
        )


class RuleComparisonResponse(ResponseModel):
    """How many lines were tried, and those that the edits change."""

    lines: int
    changes: list[LineChangeResponse]


def read_rule_edits(fields: Mapping[str, object]) -> RuleEditsRequest:
    """The validated request. Raises InputError `value_wrong`."""
    return checked(RuleEditsRequest, dict(fields))


def read_rule_part(content: bytes) -> Mapping[str, str]:
    """The edited files in the part `rules` of a form. Raises UndecodableError `not_json`, InputError `value_wrong`."""
    return read_rule_edits(read_object(content, "rules")).files


def read_rule_explanation(fields: Mapping[str, object]) -> RuleExplanationRequest:
    """The validated request. Raises InputError `value_wrong`."""
    return checked(RuleExplanationRequest, dict(fields))


def read_rule_comparison(fields: Mapping[str, object]) -> RuleComparisonRequest:
    """The validated request. Raises InputError `value_wrong`."""
    return checked(RuleComparisonRequest, dict(fields))


def _listed(items: Iterable[Item]) -> list[RuleResponse]:
    """Related rules and behaviours; words are left out, because there are many."""
    shown = [item for item in items if item.kind is not ItemKind.WORD]
    return [RuleResponse.model_validate(item) for item in shown[:MOST_RELATED]]
