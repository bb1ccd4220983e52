"""Writes the extension's tables of those rigs that the realizer knows too: `python -m plugins.rig_tables`.

Their bones are named once, in `lexicon/retarget`; the client for TypeScript takes them from there as well. Here stands
what the extension says besides: a title, and further names that a bone may have. The tables of Rigify and VRoid are the
extension's own.
"""

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

RIGS = Path(__file__).parents[1] / "lexicon" / "retarget"
TABLES = Path(__file__).parent / "blender" / "retargeting" / "tables"


@dataclass(frozen=True, slots=True)
class SharedRig:
    """A rig of the realizer in the extension: its title, a remark, and names that go before (`sooner`) or after
    (`later`) the realizer's own, by joint."""

    title: str
    remark: str
    sooner: Mapping[str, str] = field(default_factory=dict)
    later: Mapping[str, str] = field(default_factory=dict)


SHARED = {
    "mixamo": SharedRig(
        "Mixamo, Ready Player Me", "Mixamo's names, with or without a prefix; Ready Player Me has the same."
    ),
    "unreal": SharedRig(
        "Unreal's mannequin, MetaHuman",
        "Unreal's UE4 and UE5 mannequins; UE5's spine has five bones, of which the last bears the arms.",
        sooner={"upperChest": "spine_05"},
        later={"Eye": "eye_{side}"},
    ),
    "vrm": SharedRig(
        "VRM, Understudy's own", "The humanoid bones of VRM 1.0 by their own names, as in Understudy's GLB."
    ),
}


def table(name: str) -> str:
    """The extension's table of a rig, as TOML."""
    rig, shared = yaml.safe_load((RIGS / f"{name}.yaml").read_text(encoding="utf-8")), SHARED[name]
    return "\n".join(_lines(name, rig, shared)) + "\n"


def _lines(name: str, rig: Mapping[str, Any], shared: SharedRig) -> Iterator[str]:
    yield f"# {shared.remark}"
    yield f"# Written from lexicon/retarget/{name}.yaml by `python -m plugins.rig_tables`."
    yield f"title = {json.dumps(shared.title)}"
    sides = ", ".join(f"{side} = {json.dumps(word)}" for side, word in rig["sides"].items())
    yield f"sides = {{{sides}}}"
    for section in ("middle", "sided"):
        yield f"\n[{section}]"
        for joint, bone in rig[section].items():
            names = [each for each in (shared.sooner.get(joint), bone, shared.later.get(joint)) if each]
            yield f"{joint} = {json.dumps(names if len(names) > 1 else bone)}"


def main() -> None:
    for name in SHARED:
        (TABLES / f"{name}.toml").write_text(table(name), encoding="utf-8")


if __name__ == "__main__":
    main()
