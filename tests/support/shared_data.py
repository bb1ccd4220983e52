"""Data that lies beside the repository, in ../shared, and never in it: tests that need it are skipped without it."""

from pathlib import Path

import pytest

SHARED = Path(__file__).resolve().parents[3] / "shared"
MOTION_PAGE = SHARED / "motion.md"
SHARED_LINES = SHARED / "data" / "speech" / "lines"
SHARED_SPEECH = SHARED / "data" / "speech"
AVATAR = SHARED / "data" / "motion" / "avatar" / "cc0_avatar.glb"
BML_SUITE = SHARED / "data" / "bml" / "realizertester-bml1"


def needs(path: Path) -> pytest.MarkDecorator:
    """Marks a test that reads `path`, a file or folder under `SHARED`."""
    reason = f"needs ../shared/{path.relative_to(SHARED)}, which is no part of the repository"
    return pytest.mark.skipif(not path.exists(), reason=reason)
