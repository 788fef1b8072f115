// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/monotone_segments.h"

#include <cassert>

#include "core/numeric/brent.h"

namespace drillwave {

double MonotoneSegment::placeOf(double wanted) const {
    assert(wanted >= lower() && wanted <= upper());
    if (wanted == first) return start;
    if (wanted == last) return end;
    return brentRoot([&](double x) { return value(x) - wanted; }, start, first - wanted, end, last - wanted);
}

std::vector<MonotoneSegment> segmentsOf(std::span<const FitPiece> pieces, std::size_t output) {
    std::vector<MonotoneSegment> segments;
    for (const FitPiece& piece : pieces) {
        if (!piece.solved) continue;
        const Chebyshev& function = piece.outputs[output];
        std::vector<double> cuts = function.stationaryPoints();
        cuts.push_back(piece.end);
        double from = piece.start;
        for (const double cut : cuts) {
            if (cut <= from) continue;
            segments.push_back({from, cut, function(from), function(cut), &piece, output});
            from = cut;
        }
    }
    return segments;
}

}  // namespace drillwave
