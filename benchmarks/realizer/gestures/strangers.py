"""What strangers read in our gestures: black silhouettes without words, and seven meanings to choose from.

    python -m benchmarks.realizer.gestures.strangers draw FOLDER [--character NAME] [--agitation LEVEL]
    python -m benchmarks.realizer.gestures.strangers score FOLDER ANSWERS.json …

The lines of `strangers.yaml`, spoken by flite, are performed and realized; each gesture is drawn at six moments of its
stroke, from the front and three quarters, as FOLDER/NN.png, in an order by chance. FOLDER/questions.json has the seven
meanings of each (docs/families.md): the one that the choice had in mind, and six by chance of families that do not
share its lexeme. FOLDER/key.json says which is right, and is not for the strangers. ANSWERS.json is an object of
lists, the likeliest choice first: {"01": ["c", "a"]}. Chance is .14. Needs the program flite and `understudy[plot]`.
"""

import argparse
import json
import random
import re
import subprocess
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import yaml

from benchmarks.realizer.gestures.likeness import silhouette
from benchmarks.realizer.gestures.silhouettes import families_of
from understudy.model import Behavior, Channel, FloatArray, Level, Line
from understudy.models import Understudy, load_realizer
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import schedule_of
from understudy.realizer.body.motion import Motion
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.mannequin.skinning import Mannequin
from understudy.realizer.pictures.contact_sheet import Still, draw_cells
from understudy.realizer.realizing import realize
from understudy.settings import Settings

LINES = Path(__file__).with_name("strangers.yaml")
FAMILIES = Path(__file__).parents[3] / "docs" / "families.md"
VOICES = ("slt", "rms", "awb")
FRAME_RATE_HZ = 60
MOMENTS = 6
"""From the beginning of a stroke to its end, and while it is held."""

CHOICES = "abcdefg"
UNDRAWN = frozenset({"still"})
_MEANING = re.compile(r"^\| `(?P<family>\w+)` \| (?P<meaning>.+) \|$", re.MULTILINE)
_FAMILY_READ = "reading in context: "
_POINTS = frozenset({"point_here", "point_there", "point_up"})


@dataclass(frozen=True, slots=True)
class Gesture:
    """A gesture of a line as it was realized: the families of its lexeme, the one that was meant first, and the
    rotations (M, J, 4) and places of the hips (M, 3) at the moments of its stroke."""

    line: str
    lexeme: str
    families: tuple[str, ...]
    rotations: FloatArray
    hips_m: FloatArray


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("what", choices=["draw", "score"])
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("answers", type=Path, nargs="*")
    arguments.add_argument("--character", default="default")
    arguments.add_argument("--agitation", type=Level, choices=list(Level))
    options = arguments.parse_args()
    if options.what == "score":
        score(options.folder, options.answers)
        return
    options.folder.mkdir(parents=True, exist_ok=True)
    skeleton = load_realizer().performer(options.character).skeleton
    gestures = list(performed(Options(character=options.character, agitation=options.agitation)))
    random.Random(0).shuffle(gestures)
    draw(gestures, skeleton, options.folder)
    ask(gestures, options.folder)


def performed(options: Options) -> Iterator[Gesture]:
    """The gestures of all lines."""
    lines = yaml.safe_load(LINES.read_text(encoding="utf-8"))["lines"]
    realizer = load_realizer()
    with Understudy.load(Settings()) as understudy:
        for number, text in enumerate(lines):
            line = Line(said(text, VOICES[number % len(VOICES)]), text)
            performance = perform(understudy, line, options)
            motion = realize(realizer, schedule_of(performance), frame_rate_hz=FRAME_RATE_HZ)
            yield from (_gesture(text, each, motion) for each in performance.behaviors if _is_shown(each, motion))


def said(text: str, voice: str) -> bytes:
    """The WAV file of the text as flite says it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "said.wav"
        subprocess.run(["flite", "-voice", voice, "-t", text, "-o", str(path)], check=True)
        return path.read_bytes()


def _is_shown(behavior: Behavior, motion: Motion) -> bool:
    return behavior.kept and behavior.kind is Channel.GESTURE and behavior.id in motion.realized


def _gesture(line: str, behavior: Behavior, motion: Motion) -> Gesture:
    sync = motion.realized[behavior.id]
    begins_s, ends_s = sync.stroke_start or sync.start, sync.stroke_end or sync.end
    held_s = (ends_s + (sync.relax or sync.end)) / 2
    moments_s = [*np.linspace(begins_s, ends_s, MOMENTS - 1), held_s]
    frames = [int(np.argmin(np.abs(motion.body.times_s - at_s))) for at_s in moments_s]
    return Gesture(line, behavior.lexeme, families(behavior), motion.body.rotations[frames], motion.body.hips_m[frames])


def families(behavior: Behavior) -> tuple[str, ...]:
    """The families of a gesture's lexeme, the one that the choice had in mind first."""
    own = {each.removeprefix("family ") for each in families_of().get(behavior.lexeme, frozenset())}
    read = [each.name.removeprefix(_FAMILY_READ) for each in behavior.decided_by if each.name.startswith(_FAMILY_READ)]
    meant = [each for each in sorted(own) if each in read or (each in _POINTS and "point" in read)]
    return tuple(dict.fromkeys([*meant, *sorted(own)]))


def draw(gestures: Sequence[Gesture], skeleton: Skeleton, folder: Path) -> None:
    mannequin = Mannequin.around(skeleton)
    for number, gesture in enumerate(gestures):
        poses = list(zip(gesture.rotations, gesture.hips_m, strict=True))
        cells = [silhouette(mannequin, rotations, hips_m) for rotations, hips_m in poses]
        stills = [Still("", rotations) for rotations, _hips_m in poses]
        (folder / f"{number + 1:02}.png").write_bytes(draw_cells(cells, stills, columns=len(cells)))


def ask(gestures: Sequence[Gesture], folder: Path) -> None:
    """Writes the questions and their key."""
    meanings, chance = meanings_of(), random.Random(1)
    questions, key = dict[str, dict[str, str]](), dict[str, dict[str, object]]()
    for number, gesture in enumerate(gestures):
        others = sorted(meanings.keys() - set(gesture.families) - UNDRAWN)
        offered = [gesture.families[0], *chance.sample(others, len(CHOICES) - 1)]
        chance.shuffle(offered)
        named = f"{number + 1:02}"
        questions[named] = {letter: meanings[each] for letter, each in zip(CHOICES, offered, strict=True)}
        right = CHOICES[offered.index(gesture.families[0])]
        key[named] = {"right": right, "family": gesture.families[0], "lexeme": gesture.lexeme, "line": gesture.line}
    (folder / "questions.json").write_text(json.dumps(questions, indent=1, ensure_ascii=False))
    (folder / "key.json").write_text(json.dumps(key, indent=1, ensure_ascii=False))


def meanings_of() -> Mapping[str, str]:
    """The meaning of each gesture family, in the words of docs/families.md."""
    known = yaml.safe_load((FAMILIES.parents[1] / "lexicon" / "acting" / "families.yaml").read_text())["gesture"]
    found = _MEANING.finditer(FAMILIES.read_text(encoding="utf-8"))
    told = [(each["family"], each["meaning"]) for each in found]
    return {family: meaning for family, meaning in reversed(told) if family in known}


def score(folder: Path, answers: Sequence[Path]) -> None:
    key = json.loads((folder / "key.json").read_text())
    for path in answers:
        given = json.loads(path.read_text())
        first = [name for name, each in key.items() if given.get(name, [""])[:1] == [each["right"]]]
        second = [name for name, each in key.items() if each["right"] in given.get(name, [])[:2]]
        print(f"{path.name}: {len(key)} gestures, {len(first) / len(key):.2f} named at first choice, ", end="")
        print(f"{len(second) / len(key):.2f} at the first or second")
        for name in key.keys() - set(first):
            print(f"  {name} {key[name]['lexeme']} ({key[name]['family']}) in “{key[name]['line']}”: {given.get(name)}")


if __name__ == "__main__":
    main()
