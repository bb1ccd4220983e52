"""Writes trained readers as one ONNX file: `python -m training.acting.exporting MODEL.pt … encoder.onnx [--pieces N]`

Of the vocabulary those pieces stay that directed lines and treebanks use, single characters, and then the commonest by
their place in the vocabulary: what is left out is spelt with smaller pieces. It needs `pip install onnx onnx-ir` beside
what `encoder.py` needs.
"""

import argparse
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from torch import Tensor

from understudy.model import SingleArray

from .directed import FACE, FAMILIES, HEAD, read_lines
from .encoder import mean_weights, pretrained
from .graph import graph_of, write_quantized

POSITIONS = 128
MARKS = ("[PAD]", "[UNK]", "[CLS]", "[SEP]")
FIRST_WHOLE_PIECE = 1996
"""Pieces before it are marks and characters of many scripts."""

_MATRICES = {
    "query": "attention.self.query",
    "key": "attention.self.key",
    "value": "attention.self.value",
    "attended": "attention.output.dense",
    "wide": "intermediate.dense",
    "narrow": "output.dense",
}
_NORMS = {"attended": "attention.output.LayerNorm", "narrow": "output.LayerNorm"}


def kept_pieces(vocabulary: dict[str, int], used: Counter[int], count: int) -> list[int]:
    """The numbers of the pieces that stay, in the order of the vocabulary."""
    plain = [(piece, number) for piece, number in vocabulary.items() if piece.removeprefix("##").isascii()]
    order = [
        *(vocabulary[mark] for mark in MARKS),
        *(number for piece, number in plain if len(piece.removeprefix("##")) == 1),
        *(number for number, _ in used.most_common()),
        *sorted(number for _, number in plain if number >= FIRST_WHOLE_PIECE),
    ]
    return sorted(list(dict.fromkeys(order))[:count])


def weights_of(state: Mapping[str, Tensor], pieces: Sequence[int]) -> dict[str, SingleArray]:
    """The matrices (out, in) and vectors of a trained reader by our names, of the table the rows of `pieces` alone."""
    embeddings = "encoder.embeddings."
    kinds = _array(state, embeddings + "token_type_embeddings.weight")[0]
    weights = {
        "pieces.table": _array(state, embeddings + "word_embeddings.weight")[list(pieces)],
        "positions": _array(state, embeddings + "position_embeddings.weight")[:POSITIONS] + kinds,
        "start.norm": _norm(state, embeddings + "LayerNorm"),
        "out": _array(state, "out.weight"),
        "out.bias": _array(state, "out.bias"),
    }
    for layer in range(sum(name.endswith("attention.self.query.weight") for name in state)):
        prefix = f"encoder.encoder.layer.{layer}."
        for own, theirs in _MATRICES.items():
            weights[f"{layer}.{own}"] = _array(state, f"{prefix}{theirs}.weight")
            weights[f"{layer}.{own}.bias"] = _array(state, f"{prefix}{theirs}.bias")
        for own, theirs in _NORMS.items():
            weights[f"{layer}.{own}.norm"] = _norm(state, prefix + theirs)
    return weights


def _array(state: Mapping[str, Tensor], name: str) -> SingleArray:
    return np.asarray(state[name].float().numpy(), np.float32)


def _norm(state: Mapping[str, Tensor], theirs: str) -> SingleArray:
    """Scale and shift (2, D)."""
    return np.stack([_array(state, f"{theirs}.weight"), _array(state, f"{theirs}.bias")])


def _texts(directing: Path, treebanks: Path) -> list[str]:
    texts = [" ".join(line.words) for line in read_lines(directing)]
    for path in sorted(treebanks.glob("*-train.conllu")):
        rows = path.read_text(encoding="utf-8").splitlines()
        texts += [row.removeprefix("# text = ") for row in rows if row.startswith("# text = ")]
    return texts


def main() -> None:
    from transformers import AutoTokenizer

    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("models", nargs="+", type=Path, help="their weights are averaged")
    parser.add_argument("output", type=Path)
    parser.add_argument("--pieces", type=int, default=20_000)
    parser.add_argument("--shared", type=Path, default=Path("../shared"))
    arguments = parser.parse_args()
    tokenizer = AutoTokenizer.from_pretrained(pretrained())
    used: Counter[int] = Counter()
    for text in _texts(arguments.shared / "directing", arguments.shared / "data" / "treebanks"):
        used.update(tokenizer(text, add_special_tokens=False)["input_ids"])
    vocabulary = tokenizer.get_vocab()
    by_number = {number: piece for piece, number in vocabulary.items()}
    pieces = kept_pieces(vocabulary, used, arguments.pieces)
    named = {"pieces": [by_number[piece] for piece in pieces], "families": FAMILIES, "head": HEAD, "face": FACE}
    write_quantized(graph_of(weights_of(mean_weights(arguments.models), pieces), named), arguments.output)
    print(f"{arguments.output}: {arguments.output.stat().st_size / 1e6:.1f} MB, {len(pieces)} pieces")


if __name__ == "__main__":
    main()
