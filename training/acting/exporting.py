"""Writes trained readers for numpy: `python -m training.acting.exporting MODEL.pt … encoder.npz [--pieces N]`

Matrices become int8 with a float16 scale for each row. Of the vocabulary those pieces stay that directed lines and
treebanks use, single characters, and then the commonest by their place in the vocabulary: what is left out is spelt
with smaller pieces. The file is not compressed: it is read twice as fast, and 9 % larger.
"""

import argparse
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import TypeAlias

import numpy as np
from torch import Tensor

from understudy.model import SingleArray

from .directed import FACE, FAMILIES, HEAD, read_lines
from .encoder import mean_weights, pretrained

AnyArray: TypeAlias = "np.ndarray[tuple[int, ...], np.dtype[np.generic]]"

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


def exported(state: dict[str, Tensor], pieces: Iterable[tuple[str, int]]) -> dict[str, AnyArray]:
    """The arrays of the file that `app/acting/encoder.py` reads."""
    names, numbers = zip(*pieces, strict=True)
    arrays: dict[str, AnyArray] = {
        "pieces": _text(names),
        "families": _text(FAMILIES),
        "heads": _text(HEAD),
        "faces": _text(FACE),
        "heads_each_layer": np.asarray(12),
    }
    embeddings = "encoder.embeddings."
    _add_matrix(arrays, "pieces.table", _array(state, embeddings + "word_embeddings.weight")[list(numbers)])
    kinds = _array(state, embeddings + "token_type_embeddings.weight")[0]
    positions = _array(state, embeddings + "position_embeddings.weight")[:POSITIONS] + kinds
    arrays["positions"] = positions.astype(np.float16)
    _add_norm(arrays, "start.norm", state, embeddings + "LayerNorm")
    layers = sum(name.endswith("attention.self.query.weight") for name in state)
    for layer in range(layers):
        prefix = f"encoder.encoder.layer.{layer}."
        for own, theirs in _MATRICES.items():
            _add_matrix(arrays, f"{layer}.{own}", _array(state, f"{prefix}{theirs}.weight"))
            arrays[f"{layer}.{own}.bias"] = _array(state, f"{prefix}{theirs}.bias").astype(np.float16)
        for own, theirs in _NORMS.items():
            _add_norm(arrays, f"{layer}.{own}.norm", state, prefix + theirs)
    _add_matrix(arrays, "out", _array(state, "out.weight"))
    arrays["out.bias"] = _array(state, "out.bias").astype(np.float16)
    return arrays


def _array(state: dict[str, Tensor], name: str) -> SingleArray:
    return np.asarray(state[name].float().numpy(), np.float32)


def _text(names: Iterable[str]) -> AnyArray:
    return np.frombuffer("\n".join(names).encode(), np.uint8)


def _add_matrix(arrays: dict[str, AnyArray], name: str, matrix: SingleArray) -> None:
    scale = np.maximum(np.abs(matrix).max(axis=1) / 127, 1e-7).astype(np.float16)
    arrays[name] = np.clip(np.round(matrix / scale.astype(np.float32)[:, None]), -127, 127).astype(np.int8)
    arrays[f"{name}.scale"] = scale


def _add_norm(arrays: dict[str, AnyArray], name: str, state: dict[str, Tensor], theirs: str) -> None:
    both = np.stack([_array(state, f"{theirs}.weight"), _array(state, f"{theirs}.bias")])
    arrays[name] = both.astype(np.float16)


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
    pieces = [(by_number[number], number) for number in kept_pieces(vocabulary, used, arguments.pieces)]
    state = mean_weights(arguments.models)
    np.savez(arguments.output, allow_pickle=False, **exported(state, pieces))
    print(f"{arguments.output}: {arguments.output.stat().st_size / 1e6:.1f} MB, {len(pieces)} pieces")


if __name__ == "__main__":
    main()
