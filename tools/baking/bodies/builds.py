"""The bodies of the cast: one to each face, by the sliders of the package, judged by eye."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from tools.baking.heads.people import PEOPLE
from tools.baking.heads.person import Build, Person


@dataclass(frozen=True)
class Figure:
    """What a body has beside its person's sliders. height, proportions: of `Build`; shape: weights of targets of the
    body, `*` in a name stands for left and right; person: whose sliders it has, or a person of its own."""

    height: float = 0.5
    proportions: float = 0.5
    shape: Mapping[str, float] = field(default_factory=dict)
    person: Person | None = None

    def as_person(self, name: str) -> Person:
        """The person whose base mesh is this body. name: of its face."""
        person = PEOPLE[name] if self.person is None else self.person
        build = None if person.build is None else replace(
            person.build, height=self.height, proportions=self.proportions
        )  # fmt: skip
        return replace(person, build=build, shape={**person.shape, **self.shape})


FIGURES: Mapping[str, Figure] = {
    "generic": Figure(),
    "kaori": Figure(height=0.65, proportions=0.8),
    "round": Figure(height=0.5),
    "child": Figure(),
    "baby": Figure(),
    "old": Figure(height=0.4, proportions=0.4, person=Person({}, Build(gender=1.0, age=0.9, muscle=0.4, weight=0.45))),
    "man": Figure(height=0.55, proportions=0.75),
    "gaunt": Figure(height=0.6, proportions=0.4),
    "heavy": Figure(height=0.5, proportions=0.4),
    "doll": Figure(height=0.4, proportions=0.9),
    "goblin": Figure(height=0.15, proportions=0.2),
    "alien": Figure(height=0.55, proportions=0.7),
    "auntie": Figure(height=0.35, proportions=0.4, person=Person({}, Build(gender=0.1, age=0.85, weight=0.75))),
    "cat": Figure(height=0.55, proportions=0.8, person=Person({}, Build(gender=0.2, age=0.4, weight=0.35))),
    "count": Figure(height=0.6, proportions=0.6, person=Person({}, Build(gender=1.0, age=0.6, muscle=0.4, weight=0.3))),
    "dog": Figure(
        height=0.45, proportions=0.5, person=Person({}, Build(gender=0.8, age=0.45, muscle=0.6, weight=0.55))
    ),
    "noh": Figure(height=0.6, proportions=0.6, person=Person({}, Build(gender=0.1, age=0.5, race={"asian": 1.0}))),
}
"""By the name of the face; heights above 0.6 give giants (gaunt .75: 2.06 m)."""
