from threadpoolctl import threadpool_info, threadpool_limits

from silpose.core.one_thread import OneThread


def test_linear_algebra_has_one_thread_until_the_last_context_ends():
    def threads():
        return {p["num_threads"] for p in threadpool_info() if p["user_api"] == "blas"}

    with threadpool_limits(2):
        one, other = OneThread(), OneThread()
        one.__enter__()
        with other:
            assert threads() == {1}
            one.__exit__()  # overlapping, as in two threads
            assert threads() == {1}
        assert threads() == {2}
