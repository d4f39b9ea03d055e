"""Means over runs, their confidence intervals, and what can be said of a difference.

Few runs of each kind, many kinds: the scatter of one run is taken to be the same for all kinds, and pooled. Means are drawn
anew by a parametric bootstrap: normal, with a scatter that is itself drawn by the chi-squared distribution of its
degrees of freedom, so that the interval of a mean is that of Student's t, however few the runs.
"""

import numpy as np

DRAWS = 100000


def pooled_scatter(groups):
    """(standard deviation of one run, degrees of freedom) of {kind: [value, ...]}."""
    freedom = sum(len(values) - 1 for values in groups.values())
    squares = sum(((np.asarray(values) - np.mean(values)) ** 2).sum() for values in groups.values())
    return (np.sqrt(squares / freedom) if freedom else np.nan), freedom


def drawn_means(groups, seed=20100107):
    """{kind: (DRAWS,)}: means of runs drawn anew; {} when no kind has two runs."""
    scatter, freedom = pooled_scatter(groups)
    if not freedom:
        return {}
    random = np.random.default_rng(seed)
    drawn_scatter = scatter * np.sqrt(freedom / random.chisquare(freedom, DRAWS))
    return {kind: np.mean(values) + drawn_scatter * random.standard_normal(DRAWS) / np.sqrt(len(values))
            for kind, values in groups.items()}


def interval(draws):
    """95 % of the draws (low, high)."""
    return tuple(np.quantile(draws, [0.025, 0.975]))


def verdict(low, high, below, above):
    """Whether a value with the interval low .. high lies between two bounds."""
    if below <= low and high <= above:
        return "confirmed"
    return "not confirmed" if high < below or low > above else "undecided"
