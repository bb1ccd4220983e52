"""The drill in its short form, with a service of its own: no wrong response, and nothing is lost."""

import json
import random
from itertools import islice
from pathlib import Path

import pytest

from benchmarks.api.asking import Told
from benchmarks.api.batch_faults import batch_faults
from benchmarks.api.broken.breaking import json_changed
from benchmarks.api.broken.files import KINDS as FILES
from benchmarks.api.broken.files import files_broken
from benchmarks.api.broken.inputs import KINDS, inputs
from benchmarks.api.endurance import killed, soaked
from benchmarks.api.fuzzing import fuzzed
from benchmarks.api.lines import usual
from benchmarks.api.watching import serving

PATIENT = {"workers": "2", "queue_s": "600", "deadline_s": "600"}
OF_THE_MACHINE = ("/healthz", "memory", "descriptors")
"""What depends on what else runs here: the drill measures it, a test does not."""


def test_the_service_holds(tmp_path: Path) -> None:
    with serving(PATIENT, log=tmp_path / "serve.log") as service:
        bars = [
            *fuzzed(service, 60, seed=5, clients=3, keep=tmp_path),
            *soaked(service, 10, 2, warm_up=0),
            *killed(service, 2, seed=5),
        ]
    missed = [bar for bar in bars if not bar.met and not bar.what.startswith(OF_THE_MACHINE)]
    assert [str(bar) for bar in missed] == []
    log = (tmp_path / "serve.log").read_text(encoding="utf-8")
    assert "Traceback" not in log


def test_broken_files_end_in_a_result_or_an_error_of_ours() -> None:
    assert [str(bar) for bar in files_broken(30 * len(FILES), seed=8) if not bar.met] == []


def test_outputs_that_cannot_be_used_are_refused_with_their_codes() -> None:
    assert [str(bar) for bar in batch_faults() if not bar.met] == []


def test_equal_seeds_give_equal_inputs_of_every_kind() -> None:
    one, other = ([(kind, attack.path, attack.make()) for kind, attack in islice(inputs(3), 120)] for _ in range(2))
    assert one == other
    assert {kind for kind, _, _ in one} == KINDS.keys()


def test_what_is_right_is_asked_right() -> None:
    assert [attack.path for attack in usual()] == ["/functions", "/perform", "/functions", "/realize", "/perform"]


def test_json_is_changed_now_and_then() -> None:
    rng, right = random.Random(1), {"a": [1, {"b": 2}]}
    changed = [json_changed(right, rng) for _ in range(100)]
    assert 10 < sum(each == json.dumps(right).encode() for each in changed) < 60


@pytest.mark.parametrize(
    ("told", "is_fault"),
    [
        (Told(200, "application/json", b'{"a": 1}', 0.1), False),
        (Told(200, "application/json", b'{"a": NaN}', 0.1), True),
        (Told(200, "application/xml", b"", 0.1), True),
        (Told(0, "", b"", 0.1), True),
        (Told(500, "application/problem+json", b"{}", 0.1), True),
        (Told(503, "application/problem+json", b"{}", 0.1), True),
        (Told(422, "text/plain", b"no", 0.1), True),
        (
            Told(
                422,
                "application/problem+json",
                b'{"type": "t", "title": "t", "status": 422, "code": "c", "detail": "d"}',
                0.1,
            ),
            False,
        ),
    ],
)
def test_what_is_a_fault(told: Told, is_fault: bool) -> None:
    assert (told.fault is not None) == is_fault
