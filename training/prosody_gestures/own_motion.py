"""Makes speech with motion that is ours: lines of our own, said by synthetic voices and performed by the rules. The
default motion model is learnt from it.

    python -m training.prosody_gestures.own_motion OUT [--lines N]
    python -m training.prosody_gestures.own_motion OUT --train models/motion/default.npz

The first draws lines by chance from `training/acting/lines`, has flite and espeak-ng say them, performs each at another
level of agitation, and writes `VOICE_LEVEL_NAME.wav` and `.bvh` (30 frames a second) to OUT; what is there already is
left. The second learns the model as `understudy motion-model train OUT` does, but of arms, hands, trunk and head
without the fingers, which would make the file three times as large. It needs the programs flite and espeak-ng, which
the service does not.
"""

import argparse
import json
import random
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from understudy.errors import UnderstudyError
from understudy.library.motion import realize, write_motion
from understudy.library.motion_models import Pair, read_pairs, train_motion_model
from understudy.model import Level, Line
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.settings import Settings

LINES = Path(__file__).parents[1] / "acting" / "lines"
VOICES = ("slt", "rms", "awb", "kal16", "en-us+f3", "en-gb-x-rp+m3", "en-us+f5", "en-gb-scotland+f2")
FEWEST_WORDS, MOST_WORDS = 9, 24
FINGERS = ("Thumb", "Index", "Middle", "Ring", "Little")


@dataclass(frozen=True, slots=True)
class Spoken:
    """A line of ours, who says it, and how agitated it is performed."""

    name: str
    text: str
    voice: str
    level: Level

    @property
    def file_name(self) -> str:
        """What it has before its second underscore is its session: the voice and the level."""
        return f"{self.voice.replace('+', '-')}_{self.level.value}_{self.name}"


def drawn(count: int) -> list[Spoken]:
    """So many lines, drawn by chance; voices and levels take turns."""
    every = [line for path in sorted(LINES.glob("*.jsonl")) for line in _lines(path)]
    fitting = [line for line in every if FEWEST_WORDS <= len(line[1].split()) <= MOST_WORDS]
    random.Random(0).shuffle(fitting)
    levels = (Level.MEDIUM, Level.HIGH, Level.LOW)
    return [
        Spoken(name, text, VOICES[place % len(VOICES)], levels[place % len(levels)])
        for place, (name, text) in enumerate(fitting[:count])
    ]


def _lines(path: Path) -> Iterator[tuple[str, str]]:
    for row in map(json.loads, path.read_text(encoding="utf-8").splitlines()):
        if "text" in row:
            yield row["id"], row["text"]


def say(spoken: Spoken, path: Path) -> None:
    """Writes the line as its voice says it."""
    flite = spoken.voice in VOICES[:4]
    command = ["flite", "-voice", spoken.voice, "-t", spoken.text, "-o", str(path)]
    subprocess.run(command if flite else ["espeak-ng", "-v", spoken.voice, "-w", str(path), spoken.text], check=True)


def perform_all(lines: list[Spoken], output: Path) -> None:
    output.mkdir(parents=True, exist_ok=True)
    with Understudy.load(Settings()) as understudy:
        for seed, spoken in enumerate(lines):
            sound, motion = (output / f"{spoken.file_name}{end}" for end in (".wav", ".bvh"))
            if motion.exists():
                continue
            say(spoken, sound)
            try:
                options = Options(agitation=spoken.level, seed=seed)
                performance = perform(understudy, Line(sound.read_bytes(), spoken.text), options)
            except UnderstudyError as error:
                print(f"{sound}: {error.message}", flush=True)
                sound.unlink()
                continue
            motion.write_bytes(write_motion(understudy, realize(understudy, performance, fps=30), motion.name))


def without_fingers(pair: Pair) -> Pair:
    """The pair with hands but no fingers."""
    kept = [place for place, joint in enumerate(pair.joints) if not any(finger in joint for finger in FINGERS)]
    return replace(pair, joints=tuple(pair.joints[place] for place in kept), rotations=pair.rotations[:, kept])


def train(folder: Path, model: Path) -> None:
    with Understudy.load(Settings()) as understudy:
        pairs = [without_fingers(pair) for pair in read_pairs(folder, understudy.realizer)]
    learnt = train_motion_model(pairs, progress=print)
    about = f"our own performed motion, said by synthetic voices: {learnt.about}"
    content = replace(learnt, about=about).content()
    model.parent.mkdir(parents=True, exist_ok=True)
    model.write_bytes(content)
    print(f"{model}: {about}; {len(learnt.units)} units, {len(learnt.joints)} joints, {len(content) / 1000:.0f} kB")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=Path)
    parser.add_argument("--lines", type=int, default=60)
    parser.add_argument("--train", type=Path, metavar="MODEL")
    arguments = parser.parse_args()
    if arguments.train:
        train(arguments.output, arguments.train)
    else:
        perform_all(drawn(arguments.lines), arguments.output)


if __name__ == "__main__":
    main()
