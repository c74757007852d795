import numpy as np
import pytest
from tests.every import every

from storyblender.catalog.materials import MATERIALS, hex_color
from storyblender.catalog.props import PROPS, variants
from storyblender.catalog.props.variants import read_variant
from storyblender.catalog.stand_ins import guess_class
from storyblender.look import backdrop_patterns, patterns


def test_every_material_a_prop_names_exists():
    missing = {(entry.key, key) for entry in PROPS.values() for key in entry.materials.values() if key not in MATERIALS}
    assert not missing
    assert not set(variants.MATERIALS.values()) - set(MATERIALS)


def test_every_pattern_a_material_names_exists():
    assert backdrop_patterns.skyline
    assert not {entry.pattern for entry in MATERIALS.values() if entry.pattern} - set(patterns.PATTERNS)


@every("key", [key for key, entry in MATERIALS.items() if entry.pattern])
def test_a_pattern_keeps_the_mean_of_its_colour(key):
    """A red brick wall must not come out grey: the mean of the picture is near a mix of its two colours."""
    entry = MATERIALS[key]
    picture = patterns.PATTERNS[entry.pattern](64, entry.color, entry.accent, 7, **entry.params)
    assert picture.shape == (64, 64, 3) and picture.min() >= 0
    mean, one, other = picture.mean(axis=(0, 1)), np.array(entry.color), np.array(entry.accent)
    shades, shares = np.linspace(0.5, 1.6, 23), np.linspace(0, 1, 21)
    mixes = [shade * (one + share * (other - one)) for shade in shades for share in shares]
    assert min(np.linalg.norm(mean - mix) for mix in mixes) < 0.06 * np.linalg.norm(mean)


def test_hex_colours_are_linear():
    assert hex_color("#ffffff") == pytest.approx((1, 1, 1))
    assert hex_color("#808080")[0] == pytest.approx(0.2159, abs=1e-3)


def test_a_phrase_varies_a_prop():
    assert read_variant(PROPS["armchair"], "an old red leather armchair") == {"material": "leather", "color": "#9c2622"}
    assert read_variant(PROPS["car"], "a vintage car") == {"period": "1940s"}
    assert read_variant(PROPS["jewel_box"], "the open jewel box") == {"open": True}
    assert read_variant(PROPS["campfire"], "a dead campfire") == {"lit": False}
    assert read_variant(PROPS["chair"], "the chair") == {}
    assert read_variant(PROPS["paper_lantern"], "paper lantern") == {}
    assert read_variant(PROPS["jar"], "the tip jar") == {"money": True}
    assert read_variant(PROPS["tire"], "a stack of bald tires") == {"stacked": True}
    assert read_variant(PROPS["shoe"], "muddy shoes") == {"pair": True}
    assert read_variant(PROPS["shoe"], "a lost shoe") == {}
    assert read_variant(PROPS["ice_cream_scoop"], "an ice cream scoop") == {}


@pytest.mark.parametrize(
    ("name", "key"),
    [
        ("spaceship", "craft"),
        ("dragon statue", "monument"),
        ("old time machine", "machine"),
        ("two lions", "creature"),
        ("satellite dish", "appliance"),
    ],
)
def test_the_head_of_a_name_says_its_class(name, key):
    found = guess_class(name)
    assert found is not None
    assert found.key == key


def test_nothing_is_guessed_of_unknown_words():
    assert guess_class("zorblax") is None
