"""A wheel carries what authors edit and what was trained: the installed package performs without the checkout."""

import subprocess
import sys
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def test_the_wheel_performs_away_from_the_checkout(tmp_path: Path) -> None:
    build = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path)]
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
    (wheel,) = tmp_path.glob("*.whl")
    installed = tmp_path / "installed"
    zipfile.ZipFile(wheel).extractall(installed)
    program = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "import understudy; assert understudy.__file__.startswith(sys.argv[1]), understudy.__file__\n"
        "from understudy.cli.main import main\n"
        "sys.argv[:] = ['understudy', 'functions', '--text', 'No, not those.']; main()"
    )
    run = subprocess.run(
        [sys.executable, "-c", program, str(installed)], cwd=tmp_path, check=True, capture_output=True, text=True
    )
    assert '"negation"' in run.stdout
