// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gap/gap_segments.h"

#include <cassert>

#include "core/numeric/brent.h"

namespace drillwave {

double GapSegment::gapOf(double wanted) const {
    assert(wanted >= lower() && wanted <= upper());
    if (wanted == first) return start;
    if (wanted == last) return end;
    return brentRoot([&](double gap) { return value(gap) - wanted; }, start, first - wanted, end,
                     last - wanted);
}

std::vector<GapSegment> segmentsOf(const GapCurve& curve, GapOutput output) {
    const auto index = static_cast<std::size_t>(output);
    std::vector<GapSegment> segments;
    for (const GapPiece& piece : curve.pieces) {
        if (!piece.solved) continue;
        const Chebyshev& function = piece.outputs[index];
        std::vector<double> cuts = function.stationaryPoints();
        cuts.push_back(piece.end);
        double from = piece.start;
        for (const double cut : cuts) {
            if (cut <= from) continue;
            segments.push_back({from, cut, function(from), function(cut), &piece, index});
            from = cut;
        }
    }
    return segments;
}

}  // namespace drillwave
