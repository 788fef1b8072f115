// SPDX-License-Identifier: GPL-3.0-or-later
// The waves in hammer and string by places along both: values, pictures, fronts.
#pragma once

#include <cstddef>
#include <vector>

#include "core/wave/field/wave_field.h"
#include "core/wave/field/wave_fronts.h"
#include "core/wave/network/string_waves.h"

namespace drillwave {

/// Reads waves that were kept, which must outlive it. Places x are in lengths of the string from the shank:
/// the hammer is below 0, the bit at 1. Times in t0; forces in F0 and velocities in F0/Z as of a uniform rod,
/// tension and motion towards the rock positive; NaN outside of hammer and string, and later than the blow
/// was followed.
class StringField {
  public:
    /// `joints`: where each section begins, the rear of the hammer first, and where the last one ends.
    StringField(const StringWaves& waves, const std::vector<double>& joints);

    double rear() const { return m_joints.front(); }
    double end() const { return m_waves->end(); }
    /// Returns the section at a place; where two meet, the one after it.
    std::size_t sectionAt(double x) const;
    double value(WaveQuantity quantity, double x, double t) const;
    /// Returns values exact at the centre of every cell, as for a uniform rod; the work grows with the cells.
    WaveRaster raster(WaveQuantity quantity, const RasterGrid& grid) const;

    /// Returns the travel time from the shank to the bit; below, from the hammer face to its rear and back.
    double arrival() const { return m_arrival; }
    double hammerRoundTrip() const { return m_hammerRoundTrip; }
    /// Returns the paths of a front that leaves the shank at the time `start` and runs to and fro in the
    /// string, section by section; the front of the first touch also runs in the hammer. Reflections at
    /// joints have no front.
    std::vector<FrontRun> frontRuns(double start, double begin, double end) const;

  private:
    struct Column;
    Column columnAt(double x) const;
    bool isInside(double x) const { return x >= m_joints.front() && x <= m_joints.back(); }
    void addRuns(std::vector<FrontRun>& runs, std::size_t first, std::size_t last, double start,
                 long number) const;

    const StringWaves* m_waves;
    std::vector<double> m_joints;
    std::size_t m_hammerSections;
    double m_arrival = 0, m_hammerRoundTrip = 0;
};

}  // namespace drillwave
