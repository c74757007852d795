"""What a script says of the focus reaches the camera and its sentence."""

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.reader import read_script
from storyblender.memory.camera_words import camera_sentence
from storyblender.memory.shot_context import ShotContext
from storyblender.screenplay.source import read

PAGE = """INT. KITCHEN - NIGHT

ANA (30s) and BEN (40s) stand at the table with a letter between them.

{}

BEN
Then we leave tonight.
"""


def ordered(words: str) -> ShotContext:
    """Return the shot that has the words, of a page with them."""
    board = storyboard(read_script(read(PAGE.format(words))))
    (found,) = (shot for shot in board.shot_details if " focus" in sentence(shot))
    return found


def sentence(shot: ShotContext) -> str:
    """Return what the shot list says of the camera, without the words of the script."""
    names = {"ana": "Ana", "ben": "Ben"}
    return camera_sentence(shot.camera_instruction.model_copy(update={"order": ""}), names, "Kitchen")


def test_shallow_deep_and_soft_focus() -> None:
    shot = ordered("SHALLOW FOCUS ON ANA. She reads the letter.")
    shallow = shot.camera_instruction
    assert shallow.f_number == 1.4 and shallow.focus_on_ids == ("ana",) and "shallow focus" in sentence(shot)
    deep = ordered("WIDE SHOT, deep focus. Ana reads the letter.").camera_instruction
    assert deep.f_number == 32 and deep.size == "WS"
    soft = ordered("Soft focus on Ana. She smiles.").camera_instruction
    assert soft.soft_focus and soft.f_number is None


def test_a_rack_focus_goes_on_in_the_shot_that_runs() -> None:
    shot = ordered("MEDIUM SHOT OF ANA. She lifts the letter. Rack focus to Ben. He sits down.")
    instruction = shot.camera_instruction
    assert (instruction.focus, instruction.focus_to) == ("ana", "ben") and instruction.size == "MS"
    assert {"ana", "ben"} <= {*instruction.focus_on_ids}
    assert "rack focus from Ana to Ben" in sentence(shot)


def test_a_rack_focus_may_name_both_ends_and_a_thing() -> None:
    instruction = ordered("MEDIUM SHOT. Rack focus from Ben to the letter. Ana takes it.").camera_instruction
    assert (instruction.focus, instruction.focus_to) == ("ben", "letter")
