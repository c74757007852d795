"""What people have in hand after a sentence."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.reading import Reading

Read = Callable[[str], Reading]


@pytest.mark.parametrize(
    ("action", "held"),
    [
        ("ANN (30) stands in the doorway with an umbrella.", {"ann": ["umbrella"]}),
        ("ANN (30) climbs up with a lantern and a rope.", {"ann": ["lantern", "rope"]}),
        ("ANN (30) enters with a tray in her hands.", {"ann": ["tray"]}),
        ("ANN (30) and JOE (40) wait. Ann hits Joe with a spoon.", {"ann": ["spoon"]}),
        ("Three CHILDREN tiptoe past with a ladder.", {"child": ["ladder"]}),
        ("ANN (30) walks in with a hat on her head.", {}),
        ("ANN (30) sits at the table with a glass in front of her.", {}),
        ("ANN (30) looks at a box with a spoon.", {}),
    ],
)
def test_what_somebody_comes_with_is_in_the_hand(read_scene: Read, action: str, held: dict[str, list[str]]) -> None:
    assert read_scene(action).units[-1].held == held


@pytest.mark.parametrize(("where", "support"), [("on", "bed"), ("beside", None)])
def test_who_sits_beside_a_bed_is_not_on_it(read_scene: Read, where: str, support: str | None) -> None:
    assert read_scene(f"ANN (30) sits {where} the bed.").units[-1].posture == {"ann": ("sit", support)}
