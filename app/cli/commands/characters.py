"""`understudy characters`: who can perform, and how they move."""

import argparse

from ...authoring.catalogue import load_characters
from ...schemas.library import CharacterResponse
from ..files import write_standard
from ..log import Log


def run(arguments: argparse.Namespace, _log: Log) -> int:
    characters = load_characters()
    if arguments.action == "show":
        character = characters.named(arguments.name)
        write_standard(CharacterResponse.of(character).to_json(indent=2) + b"\n")
    else:
        listed = (f"{character.name:16s} {character.description}\n" for character in characters.by_name.values())
        write_standard("".join(listed).encode())
    return 0
