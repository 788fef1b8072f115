// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/wave_field.h"

#include <cassert>
#include <limits>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/history_reader.h"

namespace drillwave {

double WaveField::impactForce(double t) const {
    assert(m_impact->hasHistories());
    return drillwave::impactForce(*m_impact, t - arrival());
}

double WaveField::impactImpulse(double t) const {
    assert(m_impact->hasHistories());
    return drillwave::impactImpulse(*m_impact, t - arrival());
}

double WaveField::positiveWave(double xi, double t) const {
    assert(m_impact->hasHistories());
    return -incidentWave(*m_impact, m_delays.atBit(Heading::toBit, xi, t));
}

double WaveField::negativeWave(double xi, double t) const {
    assert(m_impact->hasHistories());
    const double s = m_delays.atBit(Heading::fromBit, xi, t);
    return -(drillwave::impactForce(*m_impact, s) - incidentWave(*m_impact, s));
}

double WaveField::force(double xi, double t) const {
    return positiveWave(xi, t) + negativeWave(xi, t);
}

double WaveField::velocity(double xi, double t) const {
    return negativeWave(xi, t) - positiveWave(xi, t);
}

WaveRaster waveRaster(const Impact& impact, WaveQuantity quantity, const RasterGrid& grid) {
    assert(impact.hasHistories() && grid.columns >= 0 && grid.rows >= 0);
    WaveRaster raster{quantity, grid, {}, 0};
    raster.values.resize(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
    HistoryReader arriving(impact), leaving(impact);
    const double incidentSign = quantity == WaveQuantity::force ? -1 : 1;
    const RodDelays delays(impact);
    for (int row = 0; row < grid.rows; ++row) {
        const double t = grid.time(row);
        for (int i = 0; i < grid.columns; ++i) {
            // To and fro, so that the next time to be read is always near the last.
            const int column = row % 2 == 0 ? i : grid.columns - 1 - i;
            const double xi = grid.xi(column);
            double value = std::numeric_limits<double>::quiet_NaN();
            if (xi >= 0 && xi <= 1)
                value = incidentSign * arriving.incident(delays.atBit(Heading::toBit, xi, t)) -
                        leaving.reflected(delays.atBit(Heading::fromBit, xi, t));
            raster.values[grid.index(column, row)] = static_cast<float>(value);
        }
    }
    raster.steps = arriving.steps() + leaving.steps();
    return raster;
}

double waveValue(const Impact& impact, WaveQuantity quantity, double xi, double t) {
    const WaveField field(impact);
    return quantity == WaveQuantity::force ? field.force(xi, t) : field.velocity(xi, t);
}

}  // namespace drillwave
