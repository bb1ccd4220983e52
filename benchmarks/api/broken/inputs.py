"""Inputs that are almost valid, of every kind that the service takes: random bytes changed, or parts of the structure.

`inputs(seed)` never ends; equal seeds give equal inputs. A third of them are bytes changed at random, the others keep
their form and are wrong inside: sizes in headers, values of the wrong kind, numbers at the ends of their range, names
that do not exist, elements where none may stand.
"""

import json
import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import islice
from types import MappingProxyType
from typing import Any

from understudy.files import resource_folder

from ...realizer.exporting.avatar_mutants import mutants, small_avatar
from ..attacks import Attack, Body, bml, form
from .audio import recordings, wav
from .bml import behaviors
from .breaking import VALUES, Rng, broken, json_changed
from .files import yaml_broken

TEXT = "No, I have never seen those."
WORDS = tuple({"text": word, "start_s": 0.1 * at, "end_s": 0.1 * (at + 1)} for at, word in enumerate(TEXT.split(), 1))

WORDS_OF_TEXT = (
    *("No", "never", "I", "you", "all", "those", "really?", "…", "—", "-", "'", '"', "(", ")", "3,000", "1/2", "$5.20"),
    *(
        "café",
        "naïve",
        "Straße",
        "日本語",
        "שלום",
        "مرحبا",
        "🙂",
        "\u200b",
        "\u202e",
        "a\u0301",
        "ﬁ",
        "Ⅳ",
        "\ufeff",
        "İ",
    ),
    *("don't", "it's", "co-op", "e.g.", "U.S.", "Dr.", "http://x.example/a?b=c", "a_b", "@x", "#y", "&amp;", "<p>"),
)


@dataclass(frozen=True, slots=True)
class Kind:
    """A kind of input: how often it comes, and how one is made."""

    share: int
    make: Callable[[Rng], Attack]


def inputs(seed: int) -> Iterator[tuple[str, Attack]]:
    """The name of its kind and the request, without end."""
    rng = random.Random(seed)
    names = list(KINDS)
    shares = [KINDS[name].share for name in names]
    while True:
        name = rng.choices(names, shares)[0]
        yield name, KINDS[name].make(rng)


def request(path: str, body: Body, accept: str = "application/json") -> Attack:
    """A request that has its body already."""
    return Attack(path, path, lambda: body, accept)


def _audio(rng: Rng) -> Attack:
    content = wav(rng) if rng.random() < 0.5 else broken(rng.choice(list(recordings().values())), rng)
    return request("/perform", form(audio=("a", content), text=TEXT, words=("w.json", words_file(WORDS))))


def words_file(words: Sequence[object]) -> bytes:
    """Words in time as JSON."""
    return json.dumps({"words": words}).encode()


def text(rng: Rng) -> str:
    """Words, marks and characters in any order."""
    parts = [rng.choice(WORDS_OF_TEXT) for _ in range(rng.choice((0, 1, 2, 5, 12, 40)))]
    if rng.random() < 0.2:
        parts.insert(
            0, rng.choice(("!", "a", "\u0301", '"', "no-", "(", "…", "'", ".", "1", ",")) * rng.choice((30, 300, 3000))
        )
    if rng.random() < 0.2:
        parts.append("".join(chr(rng.choice((rng.randrange(32, 0x2FFF), rng.randrange(0x10FFFF)))) for _ in range(20)))
    return rng.choice((" ", " ", " ", "", "\n", "\u00a0", "\u2028")).join(parts)


def _text(rng: Rng) -> Attack:
    body = {"text": text(rng), "id": rng.choice(VALUES)} if rng.random() < 0.9 else json_changed({"text": TEXT}, rng)
    content = body if isinstance(body, bytes) else json.dumps(body).encode()
    return request("/functions", ("application/json", content))


def _line(rng: Rng, **parts: tuple[str, bytes] | str | bytes) -> Attack:
    """A line whose recording is right and whose words are in time, with further parts."""
    line: dict[str, Any] = {"audio": ("a.flac", recordings()["FLAC PCM_16"]), "text": TEXT} | {
        "words": ("w.json", words_file(WORDS))
    }
    return request("/perform", form(**(line | parts)), rng.choice(("application/json", "application/xml", "*/*", "x")))


OPTIONS = {
    **{"character": "default", "agitation": "high", "seed": 7, "mode": "semantic", "listener": ["bob"]},
    **{"dialect": "bml", "timing": "sync", "lead_in_s": 1.0, "stillness": 0.5},
    "reference": {"features": "full", "recordings": 3, "mean": [0.0], "deviation": [1.0]},
}
GIVEN = [{"class": "deixis", "subtype": "self", "first": 1, "last": 1, "priority": 5}]
DIRECTION = {
    "moments": [{"first": 0, "last": 2, "stroke": 1, "importance": 3, "gesture": ["negation"], "head": ["shake"]}],
    "avoid": [{"first": 3, "last": 4, "what": ["hands"], "why": "x"}],
    "complete": False,
}
TEXTGRID = (
    b'File type = "ooTextFile"\nObject class = "TextGrid"\n\n0\n0.8\n<exists>\n1\n'
    b'"IntervalTier"\n"words"\n0\n0.8\n1\n0\n0.8\n"No,"\n'
)
CTM = b"a 1 0.1 0.1 No,\na 1 0.2 0.1 I\n"


def _options(rng: Rng) -> Attack:
    few = {name: OPTIONS[name] for name in rng.sample(list(OPTIONS), rng.randint(1, 4))}
    return _line(rng, options=json_changed(few, rng))


def _timings(rng: Rng) -> Attack:
    kind = rng.randrange(4)
    if kind < 2:
        return _line(rng, words=("w.json", json_changed({"words": list(WORDS)}, rng)))
    name, content = (("w.TextGrid", TEXTGRID), ("w.ctm", CTM))[kind - 2]
    return _line(rng, words=(rng.choice((name, name, "w.txt", "")), broken(content, rng)))


def _notes(rng: Rng) -> Attack:
    if rng.random() < 0.5:
        return _line(rng, functions=("f.json", json_changed(GIVEN, rng)))
    return _line(rng, direction=("d.json", json_changed(DIRECTION, rng)))


def _bml(rng: Rng) -> Attack:
    media_type, content = bml(behaviors(rng))
    if rng.random() < 0.05:
        content = b'<!DOCTYPE a [<!ENTITY x "y">]>' + content
    if rng.random() < 0.2:
        content = broken(content, rng)
    accept = rng.choice(("application/json", "model/gltf-binary", "text/x-bvh"))
    if rng.random() < 0.5:
        return request("/realize", (media_type, content), accept)
    options = json_changed({"fps": 30, "seed": 1, "agitation": "low", "skeleton": "vrm", "stillness": 0.2}, rng)
    return request("/realize", form(bml=("b.bml", content), options=options), accept)


def _yaml(rng: Rng) -> Attack:
    """A gesture profile with a line, or words among edited rules to be checked."""
    if rng.random() < 0.5:
        profile = (resource_folder("lexicon") / "profiles" / "sparing.yaml").read_bytes()[:4000]
        return _line(rng, profile=("p.yaml", yaml_broken(profile, rng)))
    name = "lexicon/en/spatial.yaml"
    words = yaml_broken((resource_folder("lexicon") / "en" / "spatial.yaml").read_bytes()[:4000], rng)
    body = json.dumps({"files": {name: words.decode("utf-8", "replace")}}).encode()
    return request("/rules/check", ("application/json", body))


NOD = bml('<head id="h" lexeme="NOD" start="0" end="0.4"/>')[1]


@cache
def _avatars(seed: int) -> tuple[bytes, ...]:
    return tuple(islice(mutants(small_avatar(), 50, seed), 50))


def _avatar(rng: Rng) -> Attack:
    avatar = rng.choice(_avatars(rng.randrange(400)))
    parts = form(bml=("b.bml", NOD), avatar=("a.glb", avatar), options='{"fps": 30}')
    return request("/realize", parts, "model/gltf-binary")


def _form(rng: Rng) -> Attack:
    """A form that is broken itself."""
    media_type, content = form(audio=("a.flac", b"x" * 50), text=TEXT, options="{}")
    path = rng.choice(("/perform", "/realize", "/functions"))
    odd = (
        media_type,
        media_type.upper(),
        "multipart/form-data",
        "multipart/form-data; boundary=",
        "text/plain",
        "",
        "x",
    )
    return request(
        path,
        (rng.choice(odd), broken(content, rng)),
        rng.choice(("*/*", "", "a/b;q=x", "application/json;q=0", "," * 99)),
    )


KINDS: Mapping[str, Kind] = MappingProxyType(
    {
        "audio": Kind(24, _audio),
        "text": Kind(18, _text),
        "options": Kind(14, _options),
        "timings": Kind(10, _timings),
        "functions and notes": Kind(8, _notes),
        "BML": Kind(14, _bml),
        "avatars": Kind(6, _avatar),
        "forms": Kind(6, _form),
        "YAML": Kind(4, _yaml),
    }
)
"""By name."""
