"""What the TypeScript client generates from the service agrees with the current service; `make client-types` updates
it."""

import hashlib
import subprocess
import sys
from pathlib import Path

CLIENT = Path(__file__).parents[2] / "clients" / "typescript"


def test_generated_modules_name_the_facts_of_the_service_as_it_is() -> None:
    written = [sys.executable, str(CLIENT / "scripts" / "service_facts.py")]
    facts = subprocess.run(written, check=True, capture_output=True).stdout
    for module in ("service/schema.ts", "skeletons/rigs.ts"):
        header = (CLIENT / "src" / module).read_text(encoding="utf-8").partition("\n\n")[0]
        told = f"{module} is of an older service; run make client-types"
        assert header.endswith(hashlib.sha256(facts).hexdigest()), told
