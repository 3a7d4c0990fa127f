import numpy as np

from silpose.descriptor import ContextSpace, ShapeContextHistogram


def test_everything_is_projected_to_the_plane_of_largest_variance(sequence):
    histogram = ShapeContextHistogram(codebook_size=9).fit(sequence.masks)
    described = histogram.describe(sequence.masks[:3])
    contexts = np.concatenate([one.contexts for one in histogram.describe(sequence.masks)])
    space = ContextSpace.of(contexts, histogram.codebook_, described)
    assert space.contexts.shape == (len(contexts), 2)
    assert space.centres.shape == (9, 2)
    assert [len(points) for points in space.points] == [200] * 3
    np.testing.assert_allclose(space.points[2], space.contexts[400:600], atol=1e-5)
    largest = np.linalg.eigvalsh(np.cov(contexts.T))[::-1][:2]
    np.testing.assert_allclose(np.var(space.contexts, axis=0, ddof=1), largest, rtol=1e-4)
