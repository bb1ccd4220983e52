"""The shipped characters, read once by each process that runs tests."""

from understudy.behavior.characters.overlays import Characters
from understudy.files import resource_folder

CHARACTERS = Characters.load(resource_folder("lexicon"))
DEFAULT = CHARACTERS.named("default")
