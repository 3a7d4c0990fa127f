import numpy as np

from silpose.core.skeleton import JOINTS
from silpose.fitting.geometry import SHAPES, geometry_of
from silpose.silhouette import Body, RigidLinks


def test_parents_come_before_children_and_are_ancestors(body):
    geometry = geometry_of(body)
    nodes = np.arange(len(geometry.parents))
    assert (geometry.parents < nodes).all() and geometry.parents[0] == -1
    assert geometry.ancestors[nodes, nodes].all()
    assert geometry.ancestors[nodes[1:], geometry.parents[1:]].all()
    assert geometry.ancestors[:, 0].all() and not geometry.ancestors[0, 1:].any()


def test_every_joint_turns_a_node_and_the_chest_three(body):
    turned = list(geometry_of(body).joints)
    assert {j for j in turned if j >= 0} == set(range(len(JOINTS)))
    assert turned.count(JOINTS.index("chest")) == 3


def test_slopes_lead_to_other_shapes(body):
    geometry, shape = geometry_of(body), np.zeros(SHAPES)
    shape[1] = 1.5
    other = RigidLinks.of(Body(body.kind, level=body.level, shape=list(shape)))
    found = geometry.points + np.tensordot(shape, geometry.point_slopes, 1)
    own = np.arange(found.shape[1]) < geometry.counts[:, None]
    np.testing.assert_allclose(found[own], other.points[own], atol=2e-3)
