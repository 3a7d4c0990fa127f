"""Cholesky's factor by LAPACK, called so that other threads go on.

SciPy's functions of the same names keep Python's lock while LAPACK works, so that regressors that
are fitted in threads would wait for each other.
"""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numba.extending import get_cython_function_address

from silpose.core.types import Array

_POINTER = ctypes.c_void_p


def _lapack(name: str, arguments: int) -> Any:
    """Routine of LAPACK that returns nothing; all arguments are addresses. It runs unlocked."""
    address = get_cython_function_address("scipy.linalg.cython_lapack", name)
    return ctypes.CFUNCTYPE(None, *[_POINTER] * arguments)(address)


_dpotrf = _lapack("dpotrf", 5)
_dpotrs = _lapack("dpotrs", 8)
_dpotri = _lapack("dpotri", 5)


class NotPositiveDefinite(np.linalg.LinAlgError):
    """A matrix has no Cholesky factor."""


def cholesky_in_place(matrix: Array) -> Array:
    """Replace a symmetric matrix by its Cholesky factor.

    Parameters
    ----------
    matrix : ndarray, shape (n, n)
        Contiguous by rows; its upper half is read, and overwritten with Lᵀ.

    Returns
    -------
    factor : ndarray, shape (n, n)
        The same array, for `cholesky_solve`; below the diagonal it is as it was.

    Raises
    ------
    NotPositiveDefinite
        If there is no such factor: the upper half and the diagonal are lost.
    """
    n, info = ctypes.c_int(len(matrix)), ctypes.c_int()
    assert matrix.flags.c_contiguous and matrix.dtype == np.float64
    # By rows the upper half is what LAPACK, which reads by columns, takes for the lower one.
    if len(matrix):
        _dpotrf(b"L", _at(n), matrix.ctypes.data, _at(n), _at(info))
    if info.value:
        raise NotPositiveDefinite(f"minor {info.value} of the matrix is not positive")
    return matrix


def cholesky_solve(factor: Array, target: Array) -> Array:
    """Solve M X = T by the factor of M.

    Parameters
    ----------
    factor : ndarray, shape (n, n)
        From `cholesky_in_place`.
    target : ndarray, shape (n, m)
        T.

    Returns
    -------
    x : ndarray, shape (n, m)
        In LAPACK's memory order, by columns.
    """
    solution = np.array(target, dtype=np.float64, order="F")
    n, columns, info = ctypes.c_int(len(factor)), ctypes.c_int(solution.shape[1]), ctypes.c_int()
    if len(factor):
        arguments = factor.ctypes.data, _at(n), solution.ctypes.data, _at(n), _at(info)
        _dpotrs(b"L", _at(n), _at(columns), *arguments)
    return solution


def cholesky_inverse(matrix: Array) -> Array:
    """Invert a symmetric positive definite matrix.

    Parameters
    ----------
    matrix : ndarray, shape (n, n)

    Returns
    -------
    inverse : ndarray, shape (n, n)
        Symmetric to the last digit, in LAPACK's memory order.

    Raises
    ------
    NotPositiveDefinite
        If it has no Cholesky factor.
    """
    half = cholesky_in_place(np.array(matrix, dtype=np.float64, order="C"))
    n, info = ctypes.c_int(len(half)), ctypes.c_int()
    if len(half):
        _dpotri(b"L", _at(n), half.ctypes.data, _at(n), _at(info))
    inverse = np.triu(half)
    inverse += np.triu(half, 1).T
    return np.asfortranarray(inverse.T)


def _at(number: ctypes.c_int) -> Any:
    return ctypes.byref(number)
