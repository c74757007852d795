import numpy as np
import pytest

from storyblender.library.embedder import EmbedderUnavailable, LexicalEmbedder, MiniLmEmbedder, load_embedder


def test_synonyms_are_alike_and_strangers_are_not():
    pytest.importorskip("onnxruntime")
    couch, sofa, volcano = MiniLmEmbedder().embed(["couch", "sofa", "volcano"])
    assert couch @ sofa > 0.8
    assert couch @ volcano < 0.4
    assert np.linalg.norm(sofa) == pytest.approx(1, abs=1e-5)


def test_padding_in_a_batch_does_not_change_a_vector():
    pytest.importorskip("onnxruntime")
    model = MiniLmEmbedder()
    alone = model.embed(["lamp"])[0]
    among = model.embed(["a very long description of a lamp that stands beside the old green armchair", "lamp"])[1]
    assert alone @ among > 0.98  # int8 activations are scaled per batch


def test_a_changed_model_is_refused(tmp_path):
    pytest.importorskip("onnxruntime")
    fake = tmp_path / "model.onnx"
    fake.write_bytes(b"not the model")
    with pytest.raises(EmbedderUnavailable, match="not the sentence model"):
        MiniLmEmbedder(fake)


def test_the_lexical_embedder_knows_spelling_only():
    same, plural, other = LexicalEmbedder().embed(["wooden chair", "wooden chairs", "sofa"])
    assert same @ plural > 0.9
    assert same @ other < 0.3
    assert LexicalEmbedder().embed([]).shape == (0, 512)


def test_the_same_texts_are_read_once_and_nobody_changes_what_is_remembered():
    embedder = LexicalEmbedder()
    first = embedder.embed(["chair", "sofa"])
    assert embedder.embed(["chair", "sofa"]) is first and embedder.embed(["sofa", "chair"]) is not first
    with pytest.raises(ValueError, match="read-only"):
        first[0] = 0


def test_there_is_one_sentence_model_for_all_stories():
    assert load_embedder() is load_embedder()
