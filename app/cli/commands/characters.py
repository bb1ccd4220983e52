"""`understudy characters`: who can perform, and how they move."""

import argparse

from app.catalogue import load_characters
from app.cli.files import write_standard
from app.cli.log import Log
from app.library_answers import CharacterAnswer


def run(arguments: argparse.Namespace, _log: Log) -> int:
    characters = load_characters()
    if arguments.action == "show":
        character = characters.named(arguments.name)
        write_standard(CharacterAnswer.of(character).to_json(indent=2) + b"\n")
    else:
        listed = (f"{character.name:16s} {character.description}\n" for character in characters.by_name.values())
        write_standard("".join(listed).encode())
    return 0
