from collections.abc import Callable

from storyblender.agents.director.reader.language.clauses import Clause, find_clauses
from storyblender.agents.director.reader.language.phrases import find_phrases
from storyblender.agents.director.reader.language.rewrite import regularise
from storyblender.agents.director.reader.language.words import Word, tokenize
from storyblender.agents.director.reader.people.mentions import mark_mentions
from storyblender.agents.director.reader.people.roster import Roster
from storyblender.agents.director.reading import Reading


def words_of(sentence: str) -> list[Word]:
    roster = Roster()
    for name in ("KIRA", "TOM", "MIA", "MAN #2", "SERGEANT ROOK"):
        roster.add(name)
    roster.index()
    return regularise(mark_mentions(tokenize(sentence, 0), roster))


def clauses_of(sentence: str) -> list[Clause]:
    words = words_of(sentence)
    return find_clauses(words, find_phrases(words))


def test_verbs_are_told_from_nouns() -> None:
    assert [clause.verb for clause in clauses_of("Kira sprints down the alley and drops the keys.")] == [
        "sprint",
        "drop",
    ]
    assert [clause.verb for clause in clauses_of("Sparks.")] == []
    assert clauses_of("Tom steps back, boots on, gun drawn.")[0].verb == "step"


def test_what_is_left_out_is_put_in() -> None:
    grabs, man, watching = (clauses_of(s)[0] for s in ("Grabs a shovel.", "MAN #2 on the bed.", "Watching."))
    assert (grabs.verb, grabs.subject[0].head, grabs.object[0].head) == ("grab", "", "shovel")
    assert (man.verb, man.places[0][0]) == ("be", "on")
    assert watching.verb == "watch"


def test_the_recipient_stands_before_the_thing() -> None:
    clause = clauses_of("Tom hands Mia the coffee cup.")[0]
    assert clause.recipient[0].mention and clause.recipient[0].mention.candidates[0].id == "mia"
    assert clause.object[0].key == "coffee cup"


def test_lists_of_names_are_all_subjects() -> None:
    run, climb = clauses_of("Kira, Tom and Mia run out of the building and climb into the van.")
    assert len(run.subject) == len(climb.subject) == 3


def test_an_apposition_is_taken_out_but_what_it_carries_is_kept() -> None:
    clause = clauses_of("SERGEANT ROOK, a broad man with a canister on his back, pushes through the crowd.")[0]
    assert clause.verb == "push"
    assert "with" in [preposition for preposition, _ in clause.places]


def test_what_does_not_happen_is_marked() -> None:
    assert clauses_of("Tom doesn't move.")[0].negated
    assert clauses_of("Tom leaves without looking back.")[1].unreal
    assert clauses_of("Tom wants to leave.")[1].unreal


def test_a_new_subject_after_a_conjunction() -> None:
    falls, rolls = clauses_of("Tom falls and the lantern rolls off the table.")[:2]
    assert falls.subject[0].mention
    assert rolls.subject[0].head == "lantern"


def test_offsets_point_at_the_verb() -> None:
    sentence = "Slowly, Kira climbs the fence."
    assert sentence[clauses_of(sentence)[0].at :].startswith("climbs")


def test_who_is_on_it_and_who_follows(read_scene: Callable[[str], Reading]) -> None:
    reading = read_scene("TOM pushes a gurney. On it SAM (70), pale, clutching his chest. Tom runs, followed by MIA.")
    assert ("sam", "on", "gurney") in [(r.asset_id, r.kind, r.anchor_asset_id) for _, r in reading.relations]
    assert [(d.actor, d.target) for d in reading.units[-1].deeds] == [("tom", None), ("mia", "tom")]


def test_a_verb_goes_on_after_a_comma_where_a_noun_cannot() -> None:
    verbs = [clause.verb for clause in clauses_of("Tom gives chase, slips in the water and crushes it out.")]
    assert verbs == ["give", "slip", "crush"]
    assert [clause.verb for clause in clauses_of("Two yellow eyes, then four.")] == []


def test_who_is_seen_doing_something_does_it() -> None:
    clauses = clauses_of("Tom watches Mia go to the window, part the blinds and peer down.")
    assert [clause.verb for clause in clauses] == ["watch", "go", "part", "peer"]
    assert {clause.subject[0].mention.candidates[0].id for clause in clauses[1:] if clause.subject[0].mention} == {
        "mia"
    }


def test_a_participle_may_have_a_subject_of_its_own() -> None:
    waits, runs = clauses_of("Tom waits at the wheel, engine running.")
    assert runs.absolute and runs.subject[0].head == "engine"
    assert waits.subject[0].mention


def test_the_subject_may_follow_its_verb() -> None:
    (trudges,) = [c for c in clauses_of("Behind the van, bent double, trudges SERGEANT ROOK.") if c.verb == "trudge"]
    assert trudges.object[0].mention and not trudges.subject


def test_qualities_and_pairs_are_no_things() -> None:
    assert not clauses_of("Tom breathes hard.")[0].object
    assert clauses_of("Tom strolls up and down before the jury.")[0].particle == ""


def test_a_noun_before_a_name_is_a_place() -> None:
    clause = clauses_of("In the front pew MIA dabs her eyes.")[0]
    assert clause.subject[0].mention and clause.places[0][1][0].head == "pew"


def test_what_was_done_to_somebody_is_no_deed() -> None:
    assert [clause.passive for clause in clauses_of("Mia sits on the bed, wrapped in a blanket.")] == [False, True]
