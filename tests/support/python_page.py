"""Runs the examples of docs/python.md in order, in a program that has a package called `app` of its own."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
EXAMPLES: list[tuple[str, str]] = re.findall(r"```python\n(.*?)```\n(?:\n```text\n(.*?)```)?", PAGE, flags=re.DOTALL)
"""Each example, and what the page says that it prints."""

RUN = """
import contextlib, io, json, sys
import app
names, printed = {}, []
for example in json.load(sys.stdin):
    with contextlib.redirect_stdout(io.StringIO()) as out:
        exec(compile(example, "docs/python.md", "exec"), names)
    printed.append(out.getvalue())
own = sorted(name for name in sys.modules if name.split(".")[0] == "app")
print(json.dumps({"printed": printed, "app": app.__file__, "own": own, "package": names["understudy"].__file__}))
"""


def run_page(folder: Path, package_parent: Path) -> None:
    """Runs the page in `folder` with the `understudy` that lies in `package_parent`; raises AssertionError where it
    prints something else than the page says, or where it is mixed up with the program's own `app`."""
    (folder / "app").mkdir()
    (folder / "app" / "__init__.py").write_text('"""Another program."""\n', encoding="utf-8")
    for ending in ("flac", "txt"):
        (folder / f"line.{ending}").write_bytes((ROOT / "examples" / f"example.{ending}").read_bytes())
    run = subprocess.run(
        [sys.executable, "-W", "error", "-c", RUN],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(package_parent)},
        input=json.dumps([example for example, _ in EXAMPLES]),
        text=True,
        capture_output=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    told = json.loads(run.stdout)
    assert told["printed"] == [said for _, said in EXAMPLES]
    assert (told["app"], told["own"]) == (str(folder / "app" / "__init__.py"), ["app"])
    assert Path(told["package"]).is_relative_to(package_parent)
