"""Fine-tunes the reader, so that it reads deliveries and not words alone.

    python -m training.acting.encoder fit OUT.npz [--from MODEL] [--epochs N] [--measured FILE.json] [--without KIND]
    python -m training.acting.encoder read MODEL OUT.npz [--measured FILE.json] [--without KIND]

It begins with the weights of MODEL, by default those that are shipped (models/acting/encoder.onnx; the first of them
were MiniLM's, 22.7 million weights, Apache-2.0), and after every epoch writes OUT. An eighth of the lines and
deliveries of the careful files is held out (`directed.is_held_out`), with `--without` all of a kind as well. `read`
writes what a model reads of what is held out, as (W, outputs) by the name of the line. It needs `pip install torch
onnx` beside what the program needs.

Outputs a word: worth of each family with its stroke there, within two words of it, a stroke, head movements, faces,
gaze, size and speed; each a sigmoid of the states of the word's first and last piece and of how the word is said. The
loss is the sum of their cross-entropies. What is heard of a delivery is drawn anew each epoch (`listening.py`).
"""

import argparse
import math
import random
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn.functional import binary_cross_entropy_with_logits

from understudy.behavior.reading.encoder import FIRST, LAST, MOST_PIECES, WORDS_ALONE, Delivery, features_of, pieces_of
from understudy.model import SingleArray

from .directed import (
    FACE,
    FAMILIES,
    GAZE,
    HANDS,
    HEAD,
    MANNER,
    OUTPUTS,
    DirectedLine,
    Targets,
    avoided,
    is_held_out,
    read_lines,
    targets_of,
)
from .listening import Voices, as_written, heard, voices_of
from .network import Reader, shipped_weights, with_delivery
from .recordings import read_measured

T = TypeVar("T")

SHIPPED = Path("models/acting/encoder.onnx")
EPOCHS, BATCH, WEIGHT_DECAY, WARM_UP = 4, 32, 0.01, 0.06
RATE, OUTPUT_RATE, NEW_RATE = 5e-5, 2e-4, 1e-3
"""Of the layers, the outputs, and the inputs for the delivery, which began at 0."""

FROZEN = 1
OLD_SHARE = 0.4
"""How many of the lines whose heads and faces were not directed with care are read in an epoch, drawn anew in each."""

SIZES = (len(FAMILIES), len(FAMILIES), 1, len(HEAD), len(FACE), len(GAZE), len(MANNER))
LOSS_WEIGHTS = (1.0, 0.4, 0.5, 0.25, 0.25, 0.1, 0.0)
CAREFUL_WEIGHTS = (1.0, 0.4, 0.5, 0.6, 0.6, 0.2, 0.3)
"""What the outputs count for where heads and faces were directed as carefully as hands."""

AVOIDED = 4.0
"""How much more what a director forbids at a word counts there: it is what an eager performer would show."""


@dataclass(frozen=True, slots=True, eq=False)
class Encoded:
    """A line as pieces, the outer pieces of its words (W, 2), and what it is trained towards (W, outputs) and how much
    that counts."""

    line: DirectedLine
    pieces: list[int]
    ends: "np.ndarray[tuple[int, int], np.dtype[np.int64]]"
    wanted: SingleArray
    counts: SingleArray


def encoded(line: DirectedLine, vocabulary: Mapping[str, int]) -> Encoded | None:
    """A line with its targets; None for one that is too long to be read whole."""
    numbers, ends = [vocabulary[FIRST]], np.zeros((len(line.words), 2), np.int64)
    for word, text in enumerate(line.words):
        own = pieces_of(text, vocabulary)
        ends[word] = len(numbers), len(numbers) + len(own) - 1
        numbers += own
    if len(numbers) > MOST_PIECES or not line.words:
        return None
    targets = targets_of(line)
    return Encoded(line, [*numbers, vocabulary[LAST]], ends, _wanted(targets), _counts(line, targets))


def _wanted(targets: Targets) -> SingleArray:
    """The targets in the order of the outputs (W, outputs); size and speed, in [-1, 1], as probabilities."""
    manner = np.zeros(len(MANNER), np.float32) if targets.manner is None else targets.manner
    manners = np.broadcast_to(0.5 + 0.5 * manner, (len(targets.stroke), len(MANNER)))
    parts = (
        targets.at_word,
        targets.nearby,
        targets.stroke[:, None],
        targets.head,
        targets.face,
        targets.gaze,
        manners,
    )
    return np.concatenate(parts, axis=1).astype(np.float32)


def _counts(line: DirectedLine, targets: Targets) -> SingleArray:
    """What each output of each word counts for (W, outputs)."""
    shares = CAREFUL_WEIGHTS if line.careful else LOSS_WEIGHTS
    counts = np.tile(np.repeat(shares, SIZES), (len(targets.stroke), 1)).astype(np.float32)
    counts[:, : SIZES[0]] *= targets.importance[:, None]
    counts[avoided(line)] *= AVOIDED
    if targets.manner is None:
        counts[:, -len(MANNER) :] = 0
    return counts


@dataclass(frozen=True, slots=True, eq=False)
class Training:
    """The lines of a training, what was measured in recordings, its length, a factor of its rates, and how many of the
    less careful lines an epoch has."""

    lines: Sequence[Encoded]
    checked: Sequence[Encoded]
    voices: Voices
    epochs: int
    seed: int
    pace: float = 1.0
    old_share: float = OLD_SHARE


def trained(reader: Reader, training: Training, output: Path) -> None:
    """Trains a reader, and writes its weights after each epoch."""
    torch.manual_seed(training.seed)
    chance = random.Random(training.seed)
    steps = training.epochs * math.ceil(len(_drawn(training, random.Random(0))) / BATCH)
    optimizer = _optimizer(reader, training.pace)
    schedule = torch.optim.lr_scheduler.LambdaLR(
        optimizer, lambda step: min(1.0, (step + 1) / (WARM_UP * steps)) * max(0.03, 1 - step / steps)
    )
    for epoch in range(training.epochs):
        reader.train()
        losses, began_s = [], time.monotonic()
        for batch in batches_of(_drawn(training, chance), chance, _pieces):
            loss = loss_of(reader, batch, [heard(each.line, training.voices, chance) for each in batch])
            optimizer.zero_grad()
            loss.backward()
            nn.utils.clip_grad_norm_(reader.parameters(), 1.0)
            optimizer.step()
            schedule.step()
            losses.append(float(loss.detach()))
        np.savez(output, allow_pickle=False, **reader.exported())
        print(f"epoch {epoch + 1}: loss {np.mean(losses):.3f}, {time.monotonic() - began_s:.0f} s", flush=True)
        _tell(reader, training)


def _tell(reader: Reader, training: Training) -> None:
    """Prints the loss on what is held out, as delivered and by its words alone."""
    reader.eval()
    chance = random.Random(0)
    deliveries = [each for each in training.checked if each.line.is_delivery]
    others = [each for each in training.checked if not each.line.is_delivery]
    with torch.no_grad():
        for name, lines, told in (
            ("delivered", deliveries, True),
            ("words", deliveries, False),
            ("lines", others, False),
        ):
            values = [
                float(
                    loss_of(
                        reader,
                        batch,
                        [as_written(each.line, training.voices, chance) if told else WORDS_ALONE for each in batch],
                    )
                )
                for batch in batches_of(lines, random.Random(0), _pieces)
            ]
            print(f"  held out, {name} ({len(lines)}): {np.mean(values):.3f}", flush=True)


def _drawn(training: Training, chance: random.Random) -> list[Encoded]:
    """The lines of an epoch."""
    return [each for each in training.lines if each.line.careful or chance.random() < training.old_share]


def read(reader: Reader, lines: Sequence[Encoded], voices: Voices) -> dict[str, SingleArray]:
    """What a reader makes of lines: probabilities (W, outputs) by name."""
    reader.eval()
    found: dict[str, SingleArray] = {}
    chance = random.Random(0)
    with torch.no_grad():
        for batch in batches_of(lines, chance, _pieces):
            likely = torch.sigmoid(reader(*inputs_of(batch, [as_written(each.line, voices, chance) for each in batch])))
            found |= {each.line.name: row[: len(each.ends)].numpy() for each, row in zip(batch, likely, strict=True)}
    return found


def _optimizer(reader: Reader, pace: float) -> torch.optim.Optimizer:
    named = [(name, each) for name, each in reader.weights.items() if each.requires_grad]
    new, outputs = ("heard", "direct"), ("out", "out.bias")
    known = [(name, each) for name, each in named if name not in (*new, *outputs)]
    plain = [each for name, each in known if each.ndim == 1 or name.endswith("norm")]
    matrices = [each for name, each in known if each.ndim > 1 and not name.endswith("norm")]
    return torch.optim.AdamW(
        [
            {"params": matrices, "lr": pace * RATE, "weight_decay": WEIGHT_DECAY},
            {"params": plain, "lr": pace * RATE, "weight_decay": 0.0},
            {
                "params": [each for name, each in named if name in outputs],
                "lr": pace * OUTPUT_RATE,
                "weight_decay": 0.0,
            },
            {"params": [each for name, each in named if name in new], "lr": pace * NEW_RATE, "weight_decay": 0.0},
        ]
    )


def batches_of(lines: Sequence[T], chance: random.Random, size: Callable[[T], int]) -> Iterator[list[T]]:
    """Lines of about the same size together, batches in random order."""
    ordered = sorted(lines, key=lambda each: size(each) + 6 * chance.random())
    batches = [ordered[first : first + BATCH] for first in range(0, len(ordered), BATCH)]
    chance.shuffle(batches)
    yield from batches


def _pieces(each: Encoded) -> int:
    return len(each.pieces)


def inputs_of(batch: Sequence[Encoded], told: Sequence[Delivery]) -> tuple[Tensor, Tensor, Tensor, Tensor]:
    """What a reader is given: pieces and their mask (B, P), the ends of words (B, W, 2), and how they are said."""
    features = [features_of(delivery, len(each.ends)) for each, delivery in zip(batch, told, strict=True)]
    shape = (len(batch), max(len(each.pieces) for each in batch))
    pieces, mask = np.zeros(shape, np.int64), np.zeros(shape, bool)
    ends = np.zeros((len(batch), max(len(each.ends) for each in batch), 2), np.int64)
    said = np.zeros((*shape, features[0].shape[1]), np.float32)
    for row, each in enumerate(batch):
        pieces[row, : len(each.pieces)] = each.pieces
        mask[row, : len(each.pieces)] = True
        ends[row, : len(each.ends)] = each.ends
        for word, (first, last) in enumerate(each.ends):
            said[row, first : last + 1] = features[row][word]
    return torch.from_numpy(pieces), torch.from_numpy(mask), torch.from_numpy(ends), torch.from_numpy(said)


def loss_of(reader: Reader, batch: Sequence[Encoded], told: Sequence[Delivery]) -> Tensor:
    """The sum of the cross-entropies of the outputs, a word."""
    with torch.autocast("cpu", torch.bfloat16):
        logits = reader(*inputs_of(batch, told))
    wanted, counts = torch.zeros_like(logits), torch.zeros_like(logits)
    for row, each in enumerate(batch):
        wanted[row, : len(each.ends)] = torch.from_numpy(each.wanted)
        counts[row, : len(each.ends)] = torch.from_numpy(each.counts)
    entropy = binary_cross_entropy_with_logits(logits, wanted, reduction="none")
    return (entropy * counts).sum() / sum(len(each.ends) for each in batch)


def starting_weights(path: Path) -> tuple[dict[str, SingleArray], dict[str, int]]:
    """The weights of a shipped or trained model, and the shipped vocabulary."""
    weights, named = shipped_weights(SHIPPED if path.suffix == ".npz" else path)
    vocabulary = {piece: number for number, piece in enumerate(named["pieces"])}
    if path.suffix == ".npz":
        with np.load(path) as stored:
            return {name: stored[name] for name in stored.files}, vocabulary
    heads, faces = HANDS, len(named["head"])
    kept = {place: place for place in range(heads)}
    kept |= {heads + HEAD.index(kind): heads + place for place, kind in enumerate(named["head"])}
    kept |= {heads + len(HEAD) + FACE.index(kind): heads + faces + place for place, kind in enumerate(named["face"])}
    if "heard" not in weights:
        weights = with_delivery(weights, OUTPUTS, kept)
        weights["out.bias"][-len(MANNER) :] = 0
    return weights, vocabulary


def main() -> None:
    arguments = _arguments()
    torch.set_num_threads(1)
    weights, vocabulary = starting_weights(arguments.start if arguments.task == "fit" else arguments.files[0])
    lines = [each for line in read_lines(arguments.directing) if (each := encoded(line, vocabulary))]
    checked = [each for each in lines if is_held_out(each.line, arguments.without)]
    measured = read_measured(arguments.measured) if arguments.measured else {}
    voices = voices_of(measured, (each.line for each in lines))
    if arguments.task == "read":
        np.savez_compressed(arguments.files[1], allow_pickle=False, **read(Reader(weights), checked, voices))
        return
    kept = lines if arguments.all else [each for each in lines if not is_held_out(each.line, arguments.without)]
    deliveries = sum(each.line.is_delivery for each in kept)
    print(f"{len(kept)} lines, {deliveries} of them deliveries; {len(checked)} held out", flush=True)
    training = Training(kept, checked, voices, arguments.epochs, arguments.seed, arguments.pace, arguments.old_share)
    trained(Reader(weights, frozen=arguments.frozen), training, arguments.files[0])


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("task", choices=("fit", "read"))
    parser.add_argument("files", nargs="+", type=Path)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    parser.add_argument("--from", dest="start", type=Path, default=SHIPPED)
    parser.add_argument("--measured", type=Path, help="what the analysis measured in recordings")
    parser.add_argument("--without", default="", help="a kind of line that is held out")
    parser.add_argument("--all", action="store_true", help="hold nothing out of the training")
    parser.add_argument("--epochs", type=int, default=EPOCHS)
    parser.add_argument("--pace", type=float, default=1.0, help="a factor of the learning rates")
    parser.add_argument("--old-share", type=float, default=OLD_SHARE)
    parser.add_argument("--frozen", type=int, default=FROZEN, help="how many layers, from the first, are not trained")
    parser.add_argument("--seed", type=int, default=0)
    return parser.parse_args()


if __name__ == "__main__":
    main()
