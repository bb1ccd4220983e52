"""`WS /live` from outside: a stream, what it tells, what is wrong with one, and its limits."""

import asyncio
import json
import time
from base64 import urlsafe_b64encode
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest
from fastapi.testclient import TestClient
from starlette.testclient import WebSocketTestSession
from starlette.websockets import WebSocketDisconnect

from tests.acoustic.pitch.test_streaming import LINE
from understudy.api.application import create_app
from understudy.api.live import MOST_FRAMES, MOST_OTHERS, OutgoingQueue
from understudy.api.workers.messages import LiveOutput
from understudy.api.workers.processes import Nursery
from understudy.settings import Settings

PCM = (LINE * 32767).astype("<i2").tobytes()
CHUNK_BYTES = 1280
START = {"type": "start", "sample_rate_hz": 16000}
KEY = "a-key-of-the-tests"


@contextmanager
def served(nursery: Nursery, **settings: Any) -> Iterator[TestClient]:  # noqa: ANN401
    with TestClient(create_app(Settings(**({"workers": 1} | settings)), nursery)) as client:
        yield client


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with served(nursery, live_ahead_s=1000) as client:
        yield client


def until(stream: WebSocketTestSession, kind: str) -> list[dict[str, Any]]:
    """All messages up to the first of that type."""
    found: list[dict[str, Any]] = []
    while not found or found[-1]["type"] != kind:
        found.append(stream.receive_json())
    return found


def ended(stream: WebSocketTestSession) -> int:
    """The code with which it is closed."""
    try:
        while True:
            stream.receive_json()
    except WebSocketDisconnect as closed:
        return closed.code


def wait_until_left(client: TestClient) -> None:
    """Until no stream is open, or a minute."""
    ends_s = time.monotonic() + 60
    while client.app.state.service.streams.count and time.monotonic() < ends_s:  # type: ignore[attr-defined]
        time.sleep(0.02)


def test_a_voice_is_answered_with_gestures(client: TestClient) -> None:
    with client.websocket_connect("/live") as stream:
        stream.send_json(START)
        assert stream.receive_json() == {"type": "ready", "sample_rate_hz": 16000, "character": "default"}
        for first in range(0, len(PCM), CHUNK_BYTES):
            stream.send_bytes(PCM[first : first + CHUNK_BYTES])
        stream.send_json({"type": "end"})
        told = until(stream, "done")
        assert ended(stream) == 1000
    assert {"gesture", "mouth", "eyes"} <= {each["type"] for each in told}
    gesture = next(each for each in told if each["type"] == "gesture")
    assert gesture.keys() >= {"id", "start_s", "lexeme", "hand", "sync", "heard_s", "reason"}
    assert told[-1]["duration_s"] == pytest.approx(len(LINE) / 16000, abs=1e-3)


def test_frames_are_of_the_joints_that_were_named(client: TestClient) -> None:
    with client.websocket_connect("/live") as stream:
        stream.send_json(START | {"frames": 30})
        ready = stream.receive_json()
        stream.send_bytes(PCM[:32000])
        stream.send_json({"type": "end"})
        frames = [each for each in until(stream, "done") if each["type"] == "frame"]
    assert [frame["time_s"] for frame in frames] == pytest.approx(np.arange(len(frames)) / 30, abs=1e-3)
    assert len(frames) == 31
    assert {len(frame["rotations"]) for frame in frames} == {4 * len(ready["joints"])}
    assert {len(frame["shapes"]) for frame in frames} == {len(ready["shapes"])}
    assert np.linalg.norm(np.reshape(frames[-1]["rotations"], (-1, 4)), axis=1) == pytest.approx(1, abs=1e-4)


def test_a_motion_model_moves_the_body_if_the_start_names_one(client: TestClient) -> None:
    """The shipped one: phrases are announced and decided, arms leave the rest, and no beats are made."""
    with client.websocket_connect("/live") as stream:
        stream.send_json(START | {"frames": 30, "motion_model": "default"})
        ready = stream.receive_json()
        for first in range(0, len(PCM), CHUNK_BYTES):
            stream.send_bytes(PCM[first : first + CHUNK_BYTES])
        stream.send_json({"type": "end"})
        told = until(stream, "done")
    phrases = [each for each in told if each["type"] == "phrase"]
    assert {each["decided"] for each in phrases} == {True, False}
    assert {"kind", "start_s", "heard_s"} <= phrases[0].keys()
    assert not [each for each in told if each["type"] == "gesture"]
    place = ready["joints"].index("leftLowerArm")
    turns = np.array([each["rotations"] for each in told if each["type"] == "frame"])[:, 4 * place : 4 * place + 4]
    assert np.ptp(turns, axis=0).max() > 0.05


def test_a_motion_model_that_there_is_not_is_told(client: TestClient) -> None:
    with client.websocket_connect("/live") as stream:
        stream.send_json(START | {"motion_model": "defualt"})
        error = stream.receive_json()
        assert ended(stream) == 1000
    assert error["code"] == "motion_model"
    assert "no motion model is called 'defualt'; did you mean 'default'" in error["detail"]


def test_words_are_performed_by_the_rules_until_they_are_interrupted(client: TestClient) -> None:
    words = [
        {"text": text, "start_s": 1 + 0.4 * k, "end_s": 1.4 + 0.4 * k} for k, text in enumerate(["No,", "not", "you!"])
    ]
    with client.websocket_connect("/live") as stream:
        stream.send_json(START)
        stream.receive_json()
        stream.send_json({"type": "words", "words": words})
        told = until(stream, "gesture")
        assert told[-1]["rule"]
        stream.send_json({"type": "interrupt"})
        assert until(stream, "withdrawn")[-1]["id"]
        stream.send_json({"type": "end"})
        until(stream, "done")


@pytest.mark.parametrize(
    ("message", "code"),
    [
        ({"type": "words"}, "field_missing"),
        ({"type": "words", "text": ""}, "text_empty"),
        ({"type": "words", "text": "a", "words": [{"text": "a", "start_s": 0, "end_s": 1}]}, "value_wrong"),
        ({"type": "words", "words": [{"text": "a", "start_s": 1, "end_s": 1}]}, "value_wrong"),
        ({"type": "silence", "duration_s": -1}, "value_wrong"),
    ],
)
def test_what_cannot_be_used_is_told_and_the_stream_goes_on(
    client: TestClient, message: dict[str, Any], code: str
) -> None:
    with client.websocket_connect("/live") as stream:
        stream.send_json(START)
        stream.receive_json()
        stream.send_json(message)
        error = stream.receive_json()
        assert (error["type"], error["code"], error["goes_on"]) == ("error", code, True)
        stream.send_json({"type": "end"})
        assert stream.receive_json()["type"] == "done"


@pytest.mark.parametrize(
    ("sent", "code"),
    [
        (b"\0\0", "live_not_started"),
        ('{"type": "words", "text": "yes"}', "live_not_started"),
        ("no JSON", "not_json"),
        ("[]", "not_an_object"),
        ('{"type": "stat"}', "value_wrong"),
        ('{"type": ["start"]}', "value_wrong"),
        ('{"type": "start", "sample_rate_hz": 1}', "value_wrong"),
        ('{"type": "start", "character": "nobody"}', "unknown_character"),
        ('{"type": "start", "frames": 50}', "value_wrong"),
        ('{"type": "start", "colour": "red"}', "value_wrong"),
    ],
)
def test_what_is_no_start_ends_the_stream(client: TestClient, sent: str | bytes, code: str) -> None:
    with client.websocket_connect("/live") as stream:
        stream.send_bytes(sent) if isinstance(sent, bytes) else stream.send_text(sent)
        error = stream.receive_json()
        assert (error["type"], error["code"], error["goes_on"]) == ("error", code, False)
        assert ended(stream) == 1000


@pytest.mark.parametrize(("sent", "code"), [(b"\0\0\0", "samples_odd"), (json.dumps(START), "live_started")])
def test_what_is_wrong_later_ends_it_too(client: TestClient, sent: str | bytes, code: str) -> None:
    with client.websocket_connect("/live") as stream:
        stream.send_json(START)
        stream.receive_json()
        stream.send_bytes(sent) if isinstance(sent, bytes) else stream.send_text(sent)
        assert stream.receive_json()["code"] == code
        assert ended(stream) == 1000


def test_only_so_many_streams_at_once_and_a_place_is_free_again(nursery: Nursery) -> None:
    with served(nursery, live_streams=1) as client:
        with client.websocket_connect("/live") as one:
            one.send_json(START)
            one.receive_json()
            with client.websocket_connect("/live") as other:
                assert other.receive_json()["code"] == "service_full"
                assert ended(other) == 1013
            one.close()
            wait_until_left(client)
        with client.websocket_connect("/live") as another:
            another.send_json(START)
            assert another.receive_json()["type"] == "ready"


def test_a_stream_is_no_longer_than_allowed(nursery: Nursery) -> None:
    with served(nursery, live_s=1, live_ahead_s=1000) as client, client.websocket_connect("/live") as stream:
        stream.send_json(START)
        stream.receive_json()
        stream.send_bytes(PCM[:32000])
        stream.send_bytes(PCM[:2])
        assert until(stream, "error")[-1]["code"] == "live_too_long"


def test_nobody_is_waited_for_for_ever(nursery: Nursery) -> None:
    with served(nursery, live_idle_s=0.1) as client, client.websocket_connect("/live") as stream:
        assert stream.receive_json()["code"] == "live_idle"
        assert ended(stream) == 1008


def test_keys_and_names_are_asked_for_as_everywhere(nursery: Nursery) -> None:
    with served(nursery, api_keys=KEY, allowed_hosts="testserver") as client:
        for headers in ({}, {"Authorization": "Bearer wrong"}, {"Authorization": f"Bearer {KEY}", "Host": "elsewhere"}):
            with pytest.raises(WebSocketDisconnect), client.websocket_connect("/live", headers=headers):
                pass
        with client.websocket_connect("/live", headers={"Authorization": f"Bearer {KEY}"}) as stream:
            stream.send_json(START)
            assert stream.receive_json()["type"] == "ready"
        coded = urlsafe_b64encode(KEY.encode()).decode().rstrip("=")
        with client.websocket_connect("/live", subprotocols=["understudy", f"understudy.key.{coded}"]) as stream:
            assert stream.accepted_subprotocol == "understudy"


def test_a_client_that_goes_leaves_no_process(client: TestClient) -> None:
    streams = client.app.state.service.streams  # type: ignore[attr-defined]
    with client.websocket_connect("/live") as stream:
        stream.send_json(START)
        stream.receive_json()
        assert streams.count == 1
        stream.close()
        wait_until_left(client)
    assert streams.count == 0


FRAMES, OTHER, LAST = LiveOutput(False, True), LiveOutput(False, False), LiveOutput(True, False)
PER_OUTPUT = 3


def frames(number: int) -> str:
    return "\n".join([f"frame {number}"] * PER_OUTPUT)


async def taken(unsent: OutgoingQueue) -> list[str]:
    """All that is told, up to the last."""
    lines: list[str] = []
    while True:
        output, told = await unsent.take()
        lines += told.splitlines()
        if output.ended:
            return lines


def test_nothing_is_left_out_while_there_is_room() -> None:
    async def run() -> list[str]:
        unsent = OutgoingQueue()
        for number in range(MOST_FRAMES):
            await unsent.put(FRAMES, frames(number))
        await unsent.put(LAST, "done")
        return await taken(unsent)

    told = asyncio.run(run())
    assert told == [line for number in range(MOST_FRAMES) for line in frames(number).splitlines()] + ["done"]


def test_the_newest_frames_are_kept_and_it_is_told_how_many_were_not() -> None:
    async def run() -> list[str]:
        unsent = OutgoingQueue()
        await unsent.put(OTHER, "gesture")
        for number in range(MOST_FRAMES + 1000):
            await unsent.put(FRAMES, frames(number))
        await unsent.put(LAST, "done")
        return await taken(unsent)

    skipped, gesture, *kept, done = asyncio.run(run())
    assert json.loads(skipped) == {"type": "frames_skipped", "count": 1000 * PER_OUTPUT}
    assert (gesture, done) == ("gesture", "done")
    assert kept[::PER_OUTPUT] == [f"frame {number}" for number in range(1000, 1000 + MOST_FRAMES)]


def test_what_was_told_to_be_left_out_is_not_told_again() -> None:
    async def run() -> list[str]:
        unsent = OutgoingQueue()
        for number in range(MOST_FRAMES + 1):
            await unsent.put(FRAMES, frames(number))
        await unsent.take()
        await unsent.put(LAST, "done")
        return await taken(unsent)

    assert not any("skipped" in line for line in asyncio.run(run()))


def test_all_else_waits_for_room_and_frames_do_not() -> None:
    async def run() -> None:
        unsent = OutgoingQueue()
        for number in range(MOST_OTHERS):
            await unsent.put(OTHER, f"gesture {number}")
        with pytest.raises(TimeoutError):
            await asyncio.wait_for(unsent.put(OTHER, "one too many"), 0.05)
        await unsent.put(FRAMES, frames(0))
        waiting = asyncio.create_task(unsent.put(LAST, "done"))
        told = await taken(unsent)
        await waiting
        assert told == [*(f"gesture {number}" for number in range(MOST_OTHERS)), *frames(0).splitlines(), "done"]

    asyncio.run(run())
