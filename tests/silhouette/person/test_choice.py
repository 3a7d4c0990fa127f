import pytest

from silpose.core.errors import InputError
from silpose.silhouette.person.choice import PersonChoice, check_person
from silpose.silhouette.person.components import Found, Person


def person(middle, height=100, area=1000):
    return Person([1], area, (middle - 20, 0, middle + 20, height))


def found(*people):
    return Found(sorted(people, key=lambda p: -p.area), len(people), sum(p.area for p in people))


def middles(choice, frames):
    chosen = []
    for own in frames:
        person_now = choice.choose(own)
        if person_now is not None:
            choice.keep(person_now)
        chosen.append(None if person_now is None else person_now.middle)
    return chosen


@pytest.mark.parametrize("given", [None, "largest", "left", "right", "tracked"])
def test_words(given):
    assert check_person(given) == given


@pytest.mark.parametrize("given", [2, "2"])
def test_numbers(given):
    assert check_person(given) == 2


@pytest.mark.parametrize("given", [0, "0", -1, "first", "", True, 1.5, "largest "])
def test_anything_else_is_refused(given):
    with pytest.raises(InputError, match=r"silhouette\.person .* largest, left, right, tracked"):
        check_person(given)


def test_sides_and_size_are_those_of_each_frame():
    frames = [found(person(50, area=900), person(200)), found(person(250), person(100, area=2000))]
    assert middles(PersonChoice("left"), frames) == [50, 100]
    assert middles(PersonChoice("right"), frames) == [200, 250]
    assert middles(PersonChoice("largest"), frames) == [200, 100]


def test_tracked_stays_with_a_person_who_becomes_smaller():
    frames = [found(person(50), person(200, area=900)), found(person(60, area=800), person(195))]
    assert middles(PersonChoice("tracked"), frames) == [50, 60]
    assert middles(PersonChoice(2), frames) == [200, 195]


def test_a_tracked_person_may_be_away():
    frames = [found(person(50)), found(), found(person(400)), found(person(70), person(400))]
    assert middles(PersonChoice("tracked"), frames) == [50, None, None, 70]


def test_a_number_waits_until_there_are_so_many():
    frames = [found(person(50)), found(person(50), person(200))]
    assert middles(PersonChoice(2), frames) == [None, 200]


def test_without_a_choice_the_largest_is_taken_where_the_last_one_is_gone():
    frames = [found(person(50)), found(person(600))]
    assert middles(PersonChoice(), frames) == [50, 600]


def test_a_choice_by_frame_that_switches_people_is_counted():
    stays = [found(person(50), person(200, area=900)), found(person(60), person(195, area=800))]
    crosses = [*stays, found(person(70, area=700), person(190, area=800))]
    for frames, count in ((stays, 0), (crosses, 1), (crosses[::2], 1)):
        choice = PersonChoice("largest")
        middles(choice, frames)
        assert choice.switches == count
    follows = PersonChoice("tracked")
    middles(follows, crosses)
    assert follows.switches == 0
