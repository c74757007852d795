"""Groups whose members are named at once: ``Two WIDOWS, EDNA and MARGUERITE, sit`` are two people, not four."""

from __future__ import annotations

import re

from storyblender.agents.director.naming import UPPER
from storyblender.agents.director.reader.people.roster import Roster
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_NAME = rf"(?:[{UPPER}][a-z]{{1,4}}\. )?[{UPPER}][{UPPER}.'’-]*(?: [{UPPER}][{UPPER}.'’-]*)*"
_ASIDE = r"(?:\s*\([^)]*\))?"
_MEMBERS = re.compile(
    rf"(?:{_NAME}){_ASIDE}\s*(?:,|:|—|–|--)\s+({_NAME}{_ASIDE}(?:,\s+{_NAME}{_ASIDE})*,?\s+and\s+{_NAME})"
)


@rule("people.members_of_group")
def name_groups(roster: Roster, text: str) -> None:
    """Let the people who are named right after a group be the group.

    Args:
        roster: The cast of a screenplay; groups whose members all have names leave it.
        text: The script, which the first mentions of the cast are offsets into.
    """
    for group in [person for person in roster.people if person.kind == "group" and person.role]:
        listed = _MEMBERS.match(text, group.first)
        names = re.findall(_NAME, re.sub(r"\([^)]*\)", "", listed.group(1))) if listed else []
        found = [roster.find(name) or roster.find(name.split()[-1]) for name in names]
        members = [people[0] for people in found if people]
        if len(members) == len(names) == group.count and _are_others(members, group):
            roster.remove(group)
            for member in members:
                _join(roster, member, group)


def _are_others(members: list[Person], group: Person) -> bool:
    distinct = len({member.id for member in members}) == len(members)
    return distinct and all(
        member is not group and member.count == 1 and len({member.gender, group.gender} - {"unknown"}) < 2
        for member in members
    )


def _join(roster: Roster, member: Person, group: Person) -> None:
    """Let a member answer to the noun; the plural means all of them, as of any who share a noun."""
    member.role = member.role or group.role
    roster.call(member, member.role)
    if member.gender == "unknown":
        member.gender = group.gender
