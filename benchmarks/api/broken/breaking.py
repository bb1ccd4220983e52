"""Breaks valid input: random bytes, or JSON within its structure."""

import json
import random
from copy import deepcopy
from typing import Any

Rng = random.Random

VALUES: tuple[Any, ...] = (
    *(
        None,
        True,
        False,
        "",
        "x",
        " ",
        "\u0000",
        "\ud800",
        "🙂" * 40,
        "a" * 300,
        [],
        {},
        [[]],
        {"": []},
        [None],
        ["bob"],
    ),
    *(0, 1, -1, 0.5, -0.0, 2.7, 1e-320, 1e308, 10**30, -(10**400), float("nan"), float("inf"), 2**31, 2**63, 2**64),
    *(
        "low",
        "high",
        "default",
        "semantic",
        "smartbody",
        "1",
        "true",
        "NaN",
        "../x",
        "<b>",
        "%s",
        "${x}",
        "'",
        '"',
        "\n",
    ),
)
"""What a value of a JSON document is replaced by."""


def broken(content: bytes, rng: Rng) -> bytes:
    """Bytes changed, cut off, doubled or put in at random."""
    changed = bytearray(content)
    for _ in range(rng.randint(1, 6)):
        at = rng.randrange(len(changed) + 1)
        action = rng.randrange(5)
        if action == 0:
            del changed[at:]
        elif action == 1:
            changed[at:at] = rng.randbytes(rng.randint(1, 9))
        elif action == 2:
            changed[at:at] = changed[at : at + rng.randint(1, 40)]
        elif action == 3:
            del changed[at : at + rng.randint(1, 40)]
        elif at < len(changed):
            changed[at] = rng.randrange(256)
    return bytes(changed)


def json_changed(value: object, rng: Rng) -> bytes:
    """A JSON document with some of its values replaced, left out, doubled or misspelt."""
    whole: list[Any] = [deepcopy(value)]
    for _ in range(rng.randint(0, 3)):
        inside, key = _place(whole, rng)
        action = rng.random()
        if action < 0.7 or inside is whole:
            inside[key] = deepcopy(rng.choice(VALUES))
        elif action < 0.8:
            del inside[key]
        elif isinstance(inside, list):
            inside.insert(key, deepcopy(inside[key]))
        else:
            inside[rng.choice((f"{key}x", str(key)[:-1], key.upper(), ""))] = inside[key]
    content = json.dumps(whole[0]).encode()
    return broken(content, rng) if rng.random() < 0.15 else content


def _place(whole: list[Any], rng: Rng) -> tuple[Any, Any]:
    """A random place, as the object or array it is in and its key there."""
    inside: Any = whole
    key: Any = 0
    while isinstance(inside[key], dict | list) and inside[key] and rng.random() < 0.85:
        inside = inside[key]
        key = rng.choice(list(inside)) if isinstance(inside, dict) else rng.randrange(len(inside))
    return inside, key
