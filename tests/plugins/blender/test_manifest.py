"""Extension and client are released with the package, under one version number."""

import json
import tomllib

from plugins.build_blender import SOURCE
from understudy.version import __version__


def test_the_extension_has_the_packages_version() -> None:
    manifest = tomllib.loads((SOURCE / "blender_manifest.toml").read_text(encoding="utf-8"))
    assert manifest["version"] == __version__


def test_the_client_has_the_packages_version() -> None:
    root = SOURCE.parents[1]
    client = json.loads((root / "clients" / "typescript" / "package.json").read_text(encoding="utf-8"))
    assert (client["version"], client["license"]) == (__version__, "Apache-2.0")
