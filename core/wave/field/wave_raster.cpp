// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/wave_raster.h"

#include <cassert>
#include <limits>

#include "core/wave/field/history_reader.h"
#include "core/wave/field/wave_field.h"

namespace drillwave {

WaveRaster waveRaster(const Impact& impact, WaveQuantity field, const RasterGrid& grid) {
    assert(impact.hasHistories() && grid.columns >= 0 && grid.rows >= 0);
    WaveRaster raster{field, grid, {}, 0};
    raster.values.resize(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
    // Np = −g(t − ξτ) and Nn = −r(t − (2 − ξ)τ), with times at the front end.
    HistoryReader arriving(impact), leaving(impact);
    const double incidentSign = field == WaveQuantity::force ? -1 : 1;
    const double transit = impact.roundTrip / 2;
    for (int row = 0; row < grid.rows; ++row) {
        const double s = grid.time(row) - impact.frontArrival;
        for (int i = 0; i < grid.columns; ++i) {
            // To and fro, so that the next time to be read is always near the last.
            const int column = row % 2 == 0 ? i : grid.columns - 1 - i;
            const double xi = grid.xi(column);
            double value = std::numeric_limits<double>::quiet_NaN();
            if (xi >= 0 && xi <= 1) {
                const double delay = (1 - xi) * transit;
                value = incidentSign * arriving.incident(s + delay) - leaving.reflected(s - delay);
            }
            raster.values[grid.index(column, row)] = static_cast<float>(value);
        }
    }
    raster.steps = arriving.steps() + leaving.steps();
    return raster;
}

double waveValue(const Impact& impact, WaveQuantity field, double xi, double t) {
    const double positive = positiveWave(impact, xi, t), negative = negativeWave(impact, xi, t);
    return field == WaveQuantity::force ? positive + negative : negative - positive;
}

}  // namespace drillwave
