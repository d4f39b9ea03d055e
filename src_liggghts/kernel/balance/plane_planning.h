// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Where the planes between sub-domains go, so that the heaviest sub-domain is as light as it can be
// (load balance of a brick decomposition; the partition of a chain into intervals, for all columns
// at once).
#pragma once

#include "balance/slab_weights.h"

#include <vector>

namespace ellipsoid {

/// Planes between `parts` parts of the slabs, as numbers of slabs below them: parts + 1 numbers
/// that begin with 0, end with the number of slabs and differ by at least `least_slabs`. No other
/// such planes make the heaviest part of any column lighter by more than a thousandth of what a
/// part weighs on average. Among those that are as good they lie near where the parts of all
/// columns together weigh the same.
/// @param[in] parts >= 1
/// @param[in] least_slabs thinnest part, >= 1 and <= slabs / parts
std::vector<int> plan_planes(const SlabWeights& weights, int parts, int least_slabs);

/// Weight of the heaviest part of any column.
double heaviest_part(const SlabWeights& weights, const std::vector<int>& planes);

/// Planes on the way from `present` to `wanted`, as near to these as can be: each stays between
/// those that are beside it at present, so that everything goes to a neighbouring part at most.
/// Repeated, it arrives.
std::vector<double> planes_of_next_stage(const std::vector<double>& present,
                                         const std::vector<double>& wanted);

} // namespace ellipsoid
