"""The extension is released with the package, under one version number."""

import tomllib

from plugins.build_blender import SOURCE
from understudy.version import __version__


def test_the_extension_has_the_packages_version() -> None:
    manifest = tomllib.loads((SOURCE / "blender_manifest.toml").read_text(encoding="utf-8"))
    assert manifest["version"] == __version__
