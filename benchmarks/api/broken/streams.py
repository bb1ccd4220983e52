"""Broken messages to live streams: each stream has a few that are almost valid, in any order, and ends as is told."""

import json
import random
from collections import Counter
from collections.abc import Iterator
from typing import Any

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from ..asking import in_threads
from ..bars import Bar, watched
from ..watching import HOST, Running, watching
from .breaking import Rng, broken, json_changed
from .inputs import WORDS, text

A_STREAM = 12
PATIENCE_S = 60.0
CODES = frozenset({1000, 1008, 1009, 1013, 1007, 1002})
"""With which a stream may end: done or wrong, idle, too large, no place; bytes that are no UTF-8 or no frames."""

_ALMOST: tuple[dict[str, Any], ...] = (
    {"type": "start", "sample_rate_hz": 16000, "channels": 1, "character": "default", "seed": 1, "frames": 30},
    {"type": "words", "words": list(WORDS)},
    {"type": "words", "text": "No, never."},
    {"type": "silence", "duration_s": 0.3},
    {"type": "listen"},
    {"type": "speak"},
    {"type": "interrupt"},
    {"type": "end"},
)


def message(rng: Rng) -> str | bytes:
    """One message: sound, a message with values replaced, words of any characters, or bytes at random."""
    kind = rng.random()
    if kind < 0.2:
        return rng.randbytes(2 * rng.choice((0, 1, 160, 640, 3200)))
    if kind < 0.25:
        return rng.randbytes(rng.randint(0, 99))
    if kind < 0.4:
        return json.dumps({"type": "words", "text": text(rng)})
    if kind < 0.55:
        return json.dumps(rng.choice(_ALMOST[1:-1]))
    changed = json_changed(rng.choice(_ALMOST), rng)
    return (broken(changed, rng) if kind > 0.95 else changed).decode("utf-8", "replace")


def streams_broken(service: Running, count: int, *, seed: int, clients: int) -> Iterator[Bar]:
    """So many messages."""
    ends, faults = Counter[str](), Counter[str]()
    with watching(service) as enough:
        for end, fault in in_threads(lambda one: _stream(service, one), range(seed, seed + count // A_STREAM), clients):
            ends[end] += 1
            faults.update([fault] if fault else [])
        seen = enough()
    print(f"{count} messages in {count // A_STREAM} streams; ends: {dict(ends)}")
    for fault, times in faults.most_common(10):
        print(f"  FAULT {times} x {fault}")
    yield Bar(f"wrong ends of streams with {count} broken messages", str(faults.total()), "0", not faults)
    yield from watched("broken streams", seen)


def _stream(service: Running, seed: int) -> tuple[str, str | None]:
    """How a stream ended, and what was wrong with that."""
    rng = random.Random(seed)
    told: list[str | bytes] = []
    try:
        with connect(f"ws://{HOST}:{service.port}/live", proxy=None, open_timeout=PATIENCE_S) as stream:
            _speak(stream, rng)
            while True:
                told.append(stream.recv(PATIENCE_S))
    except ConnectionClosed as closed:
        code = closed.rcvd.code if closed.rcvd else 1006
        wrong = next((each for each in told if not _is_typed(each)), None)
        fault = f"{seed}: {wrong!r}"[:200] if wrong is not None else None if code in CODES else f"{seed}: code {code}"
        return f"{code} {_code(told)}".strip(), fault
    except (OSError, TimeoutError) as error:
        return "none", f"{seed}: {type(error).__name__}"


def _speak(stream: ClientConnection, rng: Rng) -> None:
    if rng.random() < 0.9:
        stream.send(json.dumps({"type": "start"}))
    for _ in range(A_STREAM):
        stream.send(message(rng))
    stream.send(json.dumps({"type": "end"}))


def _is_typed(told: str | bytes) -> bool:
    """Whether a message has a type, and an error a code, which is not that of a mistake of ours."""
    try:
        read = json.loads(told)
    except ValueError:
        return False
    if not isinstance(read, dict) or "type" not in read:
        return False
    return read["type"] != "error" or (read.get("code") not in (None, "internal_error", "worker_lost"))


def _code(told: list[str | bytes]) -> str:
    last = json.loads(told[-1]) if told and _is_typed(told[-1]) else {}
    return str(last.get("code", ""))
