"""Generates BML from the table of its elements, with occasional unusual values."""

from collections.abc import Mapping
from xml.sax.saxutils import quoteattr

from understudy.bml.markup.elements import BML_CORE, CORE, Attribute, ElementKind, ValueKind

from .breaking import Rng

BLOCK = next(iter(BML_CORE.roots.values()))
ATTRIBUTES = (
    "id",
    "lexeme",
    "start",
    "end",
    "stroke",
    "ready",
    "relax",
    "target",
    "mode",
    "amount",
    "repetition",
    "au",
)
ATTRIBUTE_VALUES = (
    *(
        "0",
        "1",
        "-1",
        "0.5",
        "1e9",
        "1e400",
        "NaN",
        "inf",
        "1_0",
        "٣",
        "",
        " ",
        "b1:start",
        "b1:end+1",
        "x:y",
        "b2:stroke-3",
    ),
    *(
        "NOD",
        "SHAKE",
        "BEAT",
        "LEFT_HAND",
        "BOTH_HANDS",
        "b1",
        "b2",
        "default",
        "BLINK",
        "GOAL",
        "sp:T1",
        "b1:start + 0.2",
    ),
)


def behaviors(rng: Rng) -> str:
    """A few behaviours, as they stand in a block; half of the time all are right by themselves."""
    oddness = rng.choice((0.0, 0.0, 0.03, 0.3))
    kinds = [part for part in BLOCK.parts.values() if part.name != "bml"]
    return "".join(_element(rng.choice(kinds), rng, oddness=oddness) for _ in range(rng.randint(1, 4)))


def _element(kind: ElementKind, rng: Rng, *, oddness: float) -> str:
    """An element with what it needs and some of what it may have; each value is odd at the rate of `oddness`."""
    times = sorted(rng.uniform(0, 2) for _ in kind.syncs)
    timed = dict(zip(kind.syncs, times, strict=True))
    attributes = {}
    for name, attribute in kind.attributes.items():
        if attribute.required or rng.random() < (0.5 if name in ("id", "start", "end") else 0.25):
            is_odd = rng.random() < oddness
            value = rng.choice(ATTRIBUTE_VALUES) if is_odd else _value(name, attribute, timed, rng)
            attributes[rng.choice(ATTRIBUTES) if rng.random() < oddness / 5 else name] = value
    parts = [part for part in kind.parts.values() if part.name != "bml"]
    inside = [_element(rng.choice(parts), rng, oddness=oddness) for _ in range(rng.randrange(3))] if parts else []
    said = rng.choice(("No &amp; yes", "No", "&x;")) if kind.mixed or rng.random() < oddness / 5 else ""
    written = "".join(f" {name}={quoteattr(value)}" for name, value in attributes.items())
    space = f' xmlns="{kind.namespace}"' if kind.namespace != CORE else ""
    return f"<{kind.name}{space}{written}>{said}{''.join(inside)}</{kind.name}>"


def _value(name: str, attribute: Attribute, timed: Mapping[str, float], rng: Rng) -> str:
    """A value that the attribute may have."""
    if attribute.one_of:
        return rng.choice(sorted(attribute.one_of))
    if name in timed:
        return f"{timed[name]:.2f}"
    values = {
        ValueKind.ID: f"b{rng.randrange(9)}{rng.choice('abc')}",
        ValueKind.NUMBER: f"{rng.uniform(-90, 90):.1f}",
        ValueKind.SHARE: f"{rng.random():.2f}",
        ValueKind.COUNT: str(rng.randrange(5)),
        ValueKind.TIME: rng.choice(("0.5", "1.25", "b1a:start", "b2b:end + 0.2")),
    }
    return values.get(attribute.kind) or rng.choice(("NOD", "SHAKE", "BEAT", "POINTING", "SMILE", "default", "1"))
