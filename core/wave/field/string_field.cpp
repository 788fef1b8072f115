// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/string_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/numeric/stride_search.h"
#include "core/wave/problem.h"

namespace drillwave {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// One of the waves at one place, read at many times, each near the one before.
class WaveReader {
  public:
    WaveReader(const StringWaves& waves, const WaveAtPlace& wave, std::size_t near)
        : m_clocks(waves.clocks()),
          m_widths(waves.widths()),
          m_cells(*wave.cells),
          m_first(wave.first),
          m_zero(wave.zero()),
          m_begin(m_clocks.empty() ? 0 : m_clocks.front()),
          m_kept(wave.kept),
          m_rounding(waves.rounding()),
          m_step(near) {}

    double at(double t) {
        const double clock = t - m_zero;
        if (m_clocks.empty() || clock + m_rounding < m_begin) return m_first;
        if (!holds(clock + m_rounding))
            m_step = strideSearch(m_step, m_clocks.size(), [&](std::size_t step) {
                ++m_looks;
                return m_clocks[step] <= clock + m_rounding;
            });
        const double u = std::clamp((clock - m_clocks[m_step]) / m_widths[m_step], 0.0, 1.0);
        return m_kept * m_cells[m_step].value(u);
    }
    std::size_t step() const { return m_step; }
    long looks() const { return m_looks; }

  private:
    bool holds(double clock) {
        ++m_looks;
        return m_clocks[m_step] <= clock && (m_step + 1 == m_clocks.size() || clock < m_clocks[m_step + 1]);
    }

    std::span<const double> m_clocks, m_widths;
    const std::vector<WaveCell>& m_cells;
    double m_first;
    double m_zero;   ///< when its clock is at 0
    double m_begin;  ///< of its clock
    double m_kept;   ///< what is left of it on the way from the end where it entered
    double m_rounding;
    std::size_t m_step;
    long m_looks = 0;
};

}  // namespace

/// A place in a section, in its own measure.
struct StringField::Column {
    const SectionWaves* section;
    double share;

    WaveReader down(const StringWaves& waves, std::size_t near) const {
        return {waves, section->downAt(share), near};
    }
    WaveReader up(const StringWaves& waves, std::size_t near) const {
        return {waves, section->upAt(share), near};
    }
    // v0 has as many F0/Z as a force of 1 has F0.
    double valueOf(WaveQuantity quantity, double down, double up) const {
        return quantity == WaveQuantity::force ? 0 - (down + up) : (down - up) / section->impedance;
    }
};

namespace {

/// Where pieces of sections meet, which meet at `joints`.
std::vector<double> jointsOfPieces(const StringWaves& waves, const std::vector<double>& joints) {
    assert(joints.size() == waves.sections() + 1);
    std::vector<double> all{joints.front()};
    for (std::size_t j = 0; j < waves.sections(); ++j) {
        const int count = waves.piecesOf(j);
        for (int i = 1; i < count; ++i)
            all.push_back(std::lerp(joints[j], joints[j + 1], static_cast<double>(i) / count));
        all.push_back(joints[j + 1]);
    }
    return all;
}

}  // namespace

StringField::StringField(const StringWaves& waves, const std::vector<double>& joints)
    : m_waves(&waves),
      m_joints(jointsOfPieces(waves, joints)),
      m_hammerSections(static_cast<std::size_t>(std::ranges::lower_bound(m_joints, 0.0) - m_joints.begin())) {
    const std::span<const SectionWaves> sections = waves.pieces();
    assert(m_joints.size() == sections.size() + 1 && m_hammerSections < sections.size());
    for (std::size_t j = 0; j < sections.size(); ++j)
        if (j < m_hammerSections)
            m_hammerRoundTrip += 2 * sections[j].transitTime;
        else
            m_arrival += sections[j].transitTime;
}

std::size_t StringField::sectionAt(double x) const {
    const auto front = std::lower_bound(m_joints.begin() + 1, m_joints.end() - 1, x);
    return static_cast<std::size_t>(front - m_joints.begin()) - 1;
}

StringField::Column StringField::columnAt(double x) const {
    const std::size_t j = sectionAt(x);
    const double share = (x - m_joints[j]) / (m_joints[j + 1] - m_joints[j]);
    return {&m_waves->pieces()[j], std::clamp(share, 0.0, 1.0)};
}

double StringField::value(WaveQuantity quantity, double x, double t) const {
    if (!isInside(x) || !(t <= end())) return unknown;
    const Column column = columnAt(x);
    return column.valueOf(quantity, column.down(*m_waves, 0).at(t), column.up(*m_waves, 0).at(t));
}

WaveRaster StringField::raster(WaveQuantity quantity, const RasterGrid& grid) const {
    assert(grid.columns >= 0 && grid.rows >= 0);
    WaveRaster raster{quantity, grid, {}, 0};
    raster.values.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows),
                         std::numeric_limits<float>::quiet_NaN());
    std::size_t downStep = 0, upStep = 0;
    for (int i = 0; i < grid.columns; ++i) {
        const double x = grid.xi(i);
        if (!isInside(x)) continue;
        const Column column = columnAt(x);
        WaveReader down = column.down(*m_waves, downStep), up = column.up(*m_waves, upStep);
        for (int k = 0; k < grid.rows; ++k) {
            // To and fro, so that the next time to be read is always near the last.
            const int row = i % 2 == 0 ? k : grid.rows - 1 - k;
            const double t = grid.time(row);
            if (t <= end())
                raster.values[grid.index(i, row)] =
                    static_cast<float>(column.valueOf(quantity, down.at(t), up.at(t)));
        }
        downStep = down.step(), upStep = up.step();
        raster.steps += down.looks() + up.looks();
    }
    return raster;
}

// To the front from `first` to before `last`, or back where that comes first.
void StringField::addRuns(std::vector<FrontRun>& runs, std::size_t first, std::size_t last, double start,
                          long number) const {
    const bool toBit = first < last;
    const std::size_t count = toBit ? last - first : first - last;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t j = toBit ? first + i : first - 1 - i;
        const double transitTime = m_waves->pieces()[j].transitTime;
        runs.push_back({.number = number,
                        .heading = toBit ? Heading::toBit : Heading::fromBit,
                        .timeAtFront = toBit ? start + transitTime : start,
                        .transitTime = transitTime,
                        .rear = m_joints[j],
                        .front = m_joints[j + 1]});
        start += transitTime;
    }
}

std::vector<FrontRun> StringField::frontRuns(double start, double begin, double end) const {
    std::vector<FrontRun> runs;
    const std::size_t h = m_hammerSections, count = m_waves->pieces().size();
    if (start == 0) {
        addRuns(runs, h, 0, 0, 0);
        addRuns(runs, 0, h, m_hammerRoundTrip / 2, 0);
    }
    const double roundTrip = 2 * m_arrival;
    for (double trip = std::max(0.0, std::floor((begin - start) / roundTrip)); start + trip * roundTrip < end;
         ++trip) {
        const double leaves = start + trip * roundTrip;
        const long number = 2 * static_cast<long>(trip);
        addRuns(runs, h, count, leaves, number);
        addRuns(runs, count, h, leaves + m_arrival, number + 1);
    }
    std::erase_if(runs, [&](const FrontRun& run) {
        const double rear = run.timeAt(run.rear), front = run.timeAt(run.front);
        return std::max(rear, front) < begin || std::min(rear, front) > end;
    });
    return runs;
}

}  // namespace drillwave
