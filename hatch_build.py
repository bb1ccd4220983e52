"""Puts what authors edit and what was trained inside the package, in a wheel. An editable install takes none of it:
there the folders lie beside the package.
"""

from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class WheelContents(BuildHookInterface[Any]):
    """Names what a wheel contains."""

    PLUGIN_NAME = "wheel-contents"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Adds the folders of a wheel to `build_data`; `version` is "standard" or "editable"."""
        if version == "standard":
            included = ("lexicon", "models", "examples/example.flac", "examples/example.txt")
            build_data["force_include"] |= {name: f"understudy/{name}" for name in included}
