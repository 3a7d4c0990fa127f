from silpose.app.suggestions import nearest

KNOWN = ("motion", "motion.seconds", "motion.seed", "descriptor", "descriptor.radius")


def test_the_nearest_name_of_the_same_group_is_suggested():
    assert nearest("motion.secnds", KNOWN) == "; did you mean 'motion.seconds'?"
    assert nearest("motion.radius", KNOWN) == "; there are seconds, seed"


def test_a_misspelt_group_is_compared_with_groups():
    assert nearest("moton", KNOWN) == "; did you mean 'motion'?"
    assert nearest("moton.seconds", KNOWN) == "; did you mean 'motion.seconds'?"
