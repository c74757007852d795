"""Short stories in the manner of a hundred years ago: who the visitor is, whose son, when the next morning is."""

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read


def story(*paragraphs: str) -> Reading:
    return read_script(read("\n\n".join(paragraphs)))


def test_the_next_morning_is_a_scene_of_its_own_in_the_same_place() -> None:
    reading = story(
        "Anna sat in the drawing-room at night and read a letter by the lamp.",
        "In the pale sun next morning the letter lay on the floor of the room.",
        "Anna stood up. They would meet the next day.",
    )
    assert [(s.place, s.scene_type, s.time) for s in reading.scenes] == [
        ("drawing-room", "indoor", "night"),
        ("drawing-room", "indoor", "morning"),
    ]


def names(reading: Reading) -> set[str]:
    return {person.name for person in reading.people}


def test_a_family_shares_a_surname() -> None:
    reading = story(
        "Mr. Grey sat at chess with his son. The father put his king into danger.",
        '"Check," said Robert Grey.',
        "Mrs. Grey put down her book. Her husband stood up, and his wife and son laughed.",
    )
    assert names(reading) == {"Mr. Grey", "Mrs. Grey", "Robert Grey"}
    stood, *laughed = reading.units[-1].deeds
    assert (stood.actor, stood.motion) == ("mr_grey", "stand_up")
    assert {(deed.actor, deed.motion) for deed in laughed} == {("mrs_grey", "laugh"), ("robert_grey", "laugh")}


def test_the_visitor_is_who_came_last_and_the_host_who_was_there_first() -> None:
    reading = story(
        "Tom Fry sat by the fire with Anna. A tall, burly man walked into the room.",
        '"Sergeant-Major Hill," said Anna.',
        "The soldier took off his cap. The visitor sat down and his host poured the tea. The sergeant-major drank it.",
        '"It is cold," said the other.',
    )
    assert names(reading) == {"Tom Fry", "Anna", "Sergeant-Major Hill"}
    deeds = [(deed.actor, deed.motion) for unit in reading.units[-4:] for deed in unit.deeds]
    assert ("sergeant_major_hill", "take_off") in deeds
    assert ("sergeant_major_hill", "sit") in deeds
    assert ("tom_fry", "pour") in deeds
    assert ("tom_fry", "talk") in deeds


def test_a_guest_in_a_story_of_one_is_somebody_new() -> None:
    assert names(story("Anna opened the door. The guest walked in and sat down.")) == {"Anna", "guest"}


def test_the_old_man_stays_the_same_one() -> None:
    reading = story(
        "Mr. Grey sat with his son at the table.",
        "Robert Grey, his son, read a book. The old man stood up. A man walked in. The old man laughed.",
    )
    assert [deed.actor for deed in reading.units[-1].deeds] == ["mr_grey"]


def test_their_daughter_has_two_parents() -> None:
    reading = story(
        "Peter Holm sat at the table with Anna Holm and their daughter Mary.",
        '"Eat," said her father. Her mother laughed.',
    )
    assert [(deed.actor, deed.motion) for unit in reading.units[-2:] for deed in unit.deeds] == [
        ("peter_holm", "talk"),
        ("anna_holm", "laugh"),
    ]


def test_whoever_is_named_between_commas_is_one_person() -> None:
    reading = story(
        "In the study of Ivan Petrov, the postmaster of a small town, a lamp burned. Outside a storm was raging.",
        "Petrov sat by the fire, while his wife, Olga, read the newspaper. The postmaster laughed, and Olga withdrew.",
        "The husband stood up.",
    )
    assert names(reading) == {"Ivan Petrov", "Olga"}
    deeds = [(deed.actor, deed.motion) for unit in reading.units for deed in unit.deeds]
    assert ("olga", "read") in deeds
    assert deeds[-1] == ("ivan_petrov", "stand_up")
    assert reading.units[-1].on_stage == ["ivan_petrov"]


def test_a_man_announced_by_name_is_that_man() -> None:
    reading = story(
        "The two men smoked by the fire, Tom Fry and Dr. Low. A stout, red-faced man burst into the room.",
        '"Inspector Crewe, of Scotland Yard," interposed Fry, nodding to the intruder.',
        "The policeman sat down.",
    )
    assert names(reading) == {"Tom Fry", "Dr. Low", "Inspector Crewe"}
    assert [deed.target for deed in reading.units[-2].deeds] == ["inspector_crewe"] * 2
    assert reading.units[-1].deeds[0].actor == "inspector_crewe"


def test_the_door_closes_behind_who_has_gone() -> None:
    reading = story(
        "Anna and Ben sat at the table with Carl.",
        '"Good," said Anna, as the door closed behind Carl.',
        "Anna watched Ben down the road.",
        "Anna laughed.",
    )
    assert [unit.on_stage for unit in reading.units] == [["anna", "ben", "carl"]] * 2 + [["anna", "ben"], ["anna"]]


def test_who_means_the_person_before_and_the_story_goes_on_without_them() -> None:
    reading = story(
        "Anna sat in the kitchen. She watched a man outside, who, peering at the house, knocked at the gate.",
    )
    assert [(deed.actor, deed.motion) for deed in reading.units[1].deeds] == [
        ("anna", "look"), ("man", "look"), ("man", "knock"),
    ]  # fmt: skip


def test_a_subject_may_do_something_else_first() -> None:
    reading = story(
        "Mrs. Grey sat in the kitchen with Robert Grey, her son, and a cup.",
        "Mrs. Grey turned away, but her son, taking the cup, drank from it. Robert, rising to his feet, sat down.",
    )
    deeds = [(deed.actor, deed.motion) for unit in reading.units[1:] for deed in unit.deeds]
    assert ("robert_grey", "take") in deeds
    assert deeds[-2:] == [("robert_grey", "stand_up"), ("robert_grey", "sit")]


def test_a_part_of_an_animal_nobody_has_is_a_thing() -> None:
    reading = story(
        "Anna took the paw and placed it on the table. Ben laughed.", '"Why?" asked Ben.', '"Luck," came the answer.'
    )
    assert "paw" in {thing.id for thing in reading.things}
    assert [(deed.motion, deed.prop) for deed in reading.units[0].deeds] == [("take", "paw"), ("put_down", "paw")]
    assert reading.units[-1].speaker == "anna"


def test_the_title_may_tell_the_time() -> None:
    reading = story("An Evening at Home", "Anna sat by the stove in the kitchen.")
    assert reading.scenes[0].time == "evening"


def test_the_new_guest_is_not_the_guest_of_before() -> None:
    reading = story(
        "Ivan Petrov sat in the kitchen with his wife, Olga. Dr. Low walked in. The guest sat down.",
        "A young officer walked in and took off his cap. The new guest bowed to the ladies. He laughed.",
        "The old couple stood up.",
    )
    assert [deed.actor for deed in reading.units[2].deeds] == ["dr_low"]
    assert [deed.actor for unit in reading.units[4:6] for deed in unit.deeds] == ["officer", "officer"]
    assert {deed.actor for deed in reading.units[-1].deeds} == {"ivan_petrov", "olga"}


def test_who_is_called_by_title_or_by_what_they_are_to_somebody() -> None:
    reading = story(
        "Ivan Petrov sat in the kitchen with his wife, Olga, and their daughter Mary. Doctor Low walked in.",
        '"You win, Doctor Low," said Olga.',
        '"No, papa," said Mary.',
    )
    assert [unit.to for unit in reading.units[-2:]] == ["doctor_low", "ivan_petrov"]


def test_a_past_tense_after_and_is_no_flower() -> None:
    reading = story("Anna turned pale and rose. The samovar hummed upon the table.", "Anna laughed.")
    assert ("anna", "stand_up") in [(deed.actor, deed.motion) for deed in reading.units[0].deeds]
    assert [(r.asset_id, r.kind, r.anchor_asset_id) for _, r in reading.relations] == [("samovar", "on", "table")]


def test_who_takes_off_his_own_cap_is_a_man() -> None:
    reading = story(
        "Ivan Petrov sat in the kitchen and laughed. A young officer walked in. The stranger took off his cap.",
        '"Forgive me," he said.',
    )
    assert reading.units[-1].speaker == "officer"


def test_the_landlady_is_the_lady_of_the_house_and_an_officer_has_a_name() -> None:
    reading = story(
        "In the kitchen of the inn Madame Duval stirred the soup. Her son Pierre sat with his sister Jeanne.",
        "A pedlar walked in with a tall officer.",
        '"Colonel Brandt, of the Dragoons," said the landlady. The soldier took off his boots.',
        "The brother and sister stood up.",
        "The next morning the yard of the inn was white. The pedlar laughed.",
    )
    assert names(reading) == {"Madame Duval", "Pierre", "Jeanne", "pedlar", "Colonel Brandt"}
    deeds = [(deed.actor, deed.motion) for unit in reading.units for deed in unit.deeds]
    assert {("madame_duval", "talk"), ("colonel_brandt", "take_off"), ("pierre", "stand_up")} <= set(deeds)
    assert [scene.place for scene in reading.scenes] == ["kitchen", "yard"]


def test_her_sister_is_not_she_herself() -> None:
    reading = story("Nell sat in the kitchen with her sister Josie.", "Nell stood up. She kissed her sister.")
    assert [(deed.actor, deed.target) for deed in reading.units[-1].deeds] == [("nell", "josie")]


def test_a_lady_is_not_the_sir_of_her_name() -> None:
    reading = story(
        "Sir Hugh Tarrant stood before the fire, and the vicar, Mr. Pym, slept. Lady Tarrant poured the coffee.",
        "The butler walked in. The servant bowed to the baronet. Her husband laughed.",
        '"Inspector Gale?" said Sir Hugh.',
        "A thin, grey man walked in. The policeman sat down.",
    )
    assert names(reading) == {"Sir Hugh Tarrant", "Mr. Pym", "Lady Tarrant", "butler", "Inspector Gale"}
    deeds = [(deed.actor, deed.motion) for unit in reading.units for deed in unit.deeds]
    assert {("mr_pym", "sleep"), ("lady_tarrant", "pour"), ("butler", "bow"), ("inspector_gale", "sit")} <= set(deeds)


def test_the_latter_is_who_was_named_last() -> None:
    reading = story("Anna sat with Ben and Carl. Anna looked at Ben, and the latter rose and walked to the door.")
    assert [(deed.actor, deed.motion) for deed in reading.units[-1].deeds] == [
        ("anna", "look"), ("ben", "stand_up"), ("ben", "walk"),
    ]  # fmt: skip


def test_a_trade_never_introduced_is_that_of_the_stranger() -> None:
    ferry = (
        "Anna sat on the jetty. A man in a grey coat stood on the landing with a tripod.",
        "The man spoke to Anna. She rowed him over.",
    )
    assert names(story(*ferry, "The surveyor did not look up.")) == {"Anna", "surveyor"}
    assert names(story(*ferry, "The inspector came out of the hut.")) == {"Anna", "man", "inspector"}
    assert names(story(*ferry, "The waiter brought the man a glass.")) == {"Anna", "man", "waiter"}


def test_a_name_after_a_colon_is_that_of_who_stood_there() -> None:
    assert names(story("Anna opened the door. On the step stood a boy with a lantern: Goran. He came in.")) == {
        "Anna",
        "Goran",
    }
    assert names(story("Anna opened the door. A tall man stood on the step. It was Goran. He came in.")) == {
        "Anna",
        "Goran",
    }


def test_the_bird_is_the_goose_of_before() -> None:
    assert names(story("Anna sat with a goose under her arm. The bird hissed. Anna stroked the bird.")) == {
        "Anna",
        "goose",
    }


def test_a_trade_without_an_article_is_the_named_person() -> None:
    text = "Mr. Josiah Finch, for eleven years confidential clerk to Crake, sat down. The clerk opened the box.\n" * 2
    reading = read_script(read(text))
    assert [person.name for person in reading.people] == ["Mr. Josiah Finch"]


def test_a_vehicle_with_the_name_of_a_trade_is_nobody() -> None:
    reading = read_script(read("Edith climbed into the old coach. The coach ran on. Edith looked out of the window.\n"))
    assert [person.name for person in reading.people] == ["Edith"]
