"""What the TypeScript client generates from the service agrees with the current service; `make client-types` updates
it."""

import hashlib
import subprocess
import sys
from pathlib import Path

import pytest

CLIENT = Path(__file__).parents[2] / "clients" / "typescript"


@pytest.mark.parametrize("module", ["service/schema.ts", "skeletons/rigs.ts"])
def test_generated_modules_name_the_facts_of_the_service_as_it_is(module: str) -> None:
    written = [sys.executable, str(CLIENT / "scripts" / "service_facts.py")]
    facts = subprocess.run(written, check=True, capture_output=True).stdout
    header = (CLIENT / "src" / module).read_text(encoding="utf-8").partition("\n\n")[0]
    assert header.endswith(hashlib.sha256(facts).hexdigest()), f"{module} is of an older service; run make client-types"
