// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/proof/force_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/wave/field/bit_history.h"

namespace drillwave {

namespace {

/// Largest difference at a fraction of each piece of `impact`, taken from inside the piece.
double largestAt(double fraction, const Impact& impact, const Impact& reference) {
    double largest = 0;
    for (const PiecewisePolynomial::Piece& piece : impact.force.pieces()) {
        const double x = fraction * piece.length;
        const double s = timeOfRecorded(impact, piece.start) + x;
        const double difference = impact.force.value(piece, x) - impactForce(reference, s);
        largest = std::max(largest, std::abs(difference));
    }
    return largest;
}

}  // namespace

ForceDifference forceDifference(const Impact& impact, const Impact& reference) {
    assert(impact.hasHistories() && reference.hasHistories());
    ForceDifference difference;
    difference.inMiddles = largestAt(0.5, impact, reference);
    difference.largest = std::max({difference.inMiddles, largestAt(0, impact, reference),
                                   largestAt(1, impact, reference), largestAt(0.5, reference, impact)});
    return difference;
}

}  // namespace drillwave
