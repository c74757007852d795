from storyblender.agents.concept_artist.formatter import FormatCritic, Formatter, FormatView
from storyblender.memory.asset_sheet import AssetDimension
from storyblender.memory.measure import AssetMeasure
from storyblender.reflection import reflect


def measure(dimensions, faces=100):
    return AssetMeasure(asset_id="it", digest="d", geometry_hash="g", dimensions=dimensions, faces=faces)


def test_a_model_in_millimetres_is_told_its_height():
    critique = FormatCritic().judge(None, FormatView(measure((450.0, 500.0, 900.0))))
    assert critique.faults[0].kind == "unit"
    assert 0.5 < critique.faults[0].fix["height"] < 1.5


def test_a_fitting_size_passes_and_a_wrong_one_is_fixed():
    fitting = FormatView(measure((0.5, 0.5, 0.9)), AssetDimension(height=0.9))
    assert FormatCritic().judge(fitting.wanted, fitting).score == 10
    wrong = FormatView(measure((0.5, 0.5, 0.9)), AssetDimension(height=1.8))
    critique = FormatCritic().judge(wrong.wanted, wrong)
    assert critique.faults[0].fix == {"height": 1.8}
    assert Formatter().refine(None, critique, wrong) == AssetDimension(height=1.8)


def test_an_empty_model_is_rejected():
    outcome = reflect(
        "asset_formatter", "it", FormatView(measure((0, 0, 0), 0)), Formatter(), FormatCritic(), horizon=1
    )
    assert outcome.critique.score == 1.0
