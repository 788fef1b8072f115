// SPDX-License-Identifier: GPL-3.0-or-later
// Force and particle velocity over a grid of sections and times: the x–t picture of a blow.
#pragma once

#include <cstddef>
#include <vector>

#include "core/wave/impact.h"

namespace drillwave {

/// What is looked at in the rod.
enum class WaveQuantity {
    force,     ///< N = Np + Nn [F0], tension positive
    velocity,  ///< v = (−Np + Nn)/Z [F0/Z], positive towards the rock
};

/// Cells of equal size over a rectangle of ξ = x/L and global time t/t0.
struct RasterGrid {
    double xiBegin = 0, xiEnd = 1;
    int columns = 0;
    double timeBegin = 0, timeEnd = 1;
    int rows = 0;
    bool operator==(const RasterGrid&) const = default;

    /// Centre of a cell; may lie outside the rod.
    double xi(int column) const { return xiBegin + (xiEnd - xiBegin) * (column + 0.5) / columns; }
    double time(int row) const { return timeBegin + (timeEnd - timeBegin) * (row + 0.5) / rows; }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};

/// The quantity at the centres of the cells.
struct WaveRaster {
    WaveQuantity quantity = WaveQuantity::force;
    RasterGrid grid;
    std::vector<float> values;  ///< row by row from timeBegin; NaN outside the rod
    long steps = 0;             ///< pieces of the histories looked at: a few for each cell at most
};

/// Exact at every centre: jumps stay jumps at any size of the cells. Needs an impact solved with
/// Detail::histories. The work grows with the number of cells, hardly with that of pieces or of round trips.
WaveRaster waveRaster(const Impact& impact, WaveQuantity quantity, const RasterGrid& grid);

/// The quantity at one place, dimensionless as above.
double waveValue(const Impact& impact, WaveQuantity quantity, double xi, double t);

}  // namespace drillwave
