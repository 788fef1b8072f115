// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/string_envelope.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace drillwave {
namespace {

/// One of the waves at a place, cell by cell over global time.
class PassingCells {
  public:
    PassingCells(const StringWaves& waves, const WaveAtPlace& wave)
        : m_clocks(waves.clocks()),
          m_widths(waves.widths()),
          m_cells(*wave.cells),
          m_first(WaveCell::constant(wave.first)),
          m_zero(wave.zero()),
          m_kept(wave.kept) {
        advance(waves.rounding());
    }

    /// What it is between time and next().
    const WaveCell& cell() const { return m_behind == 0 ? m_first : m_cells[m_behind - 1]; }
    /// What is left of that on the way from the end where it entered.
    double kept() const { return m_behind == 0 ? 1 : m_kept; }
    double next() const {
        return m_behind < m_clocks.size() ? m_zero + m_clocks[m_behind]
                                          : std::numeric_limits<double>::infinity();
    }
    /// To the cell at a time.
    void advance(double time) {
        while (next() <= time) ++m_behind;
    }
    WaveCell between(double from, double to) const {
        if (m_behind == 0) return m_first;
        const double start = m_zero + m_clocks[m_behind - 1], width = m_widths[m_behind - 1];
        const auto share = [&](double time) { return std::clamp((time - start) / width, 0.0, 1.0); };
        return m_kept * cell().part(share(from), share(to));
    }

  private:
    std::span<const double> m_clocks, m_widths;
    const std::vector<WaveCell>& m_cells;
    WaveCell m_first;
    double m_zero;  ///< when its clock is at 0
    double m_kept;
    std::size_t m_behind = 0;  ///< how many cells have begun
};

void note(SectionPeak& peak, const WaveCell& force, double from, double to) {
    const WaveCell::Peak most = force.peak();
    if (!(most.value > peak.force)) return;
    peak.force = most.value;
    peak.time = std::lerp(from, to, most.place);
}

void note(SectionPeak& peak, double force, double time) {
    if (force > peak.force) peak.force = force, peak.time = time;
}

// What is known is better than the waves that were kept.
void hold(SectionPeak& here, const SectionPeak& known) {
    if (known.place == here.place && known.force > here.force) here = known;
    here.force = std::min(here.force, known.force);
}

/// In `count` equal parts, and where the largest forces are.
std::vector<double> placesOf(const SectionForces* peaks, int count) {
    std::vector<double> places;
    for (int i = 0; i <= count; ++i) places.push_back(static_cast<double>(i) / count);
    if (peaks)
        for (const Load load : loads)
            if (const SectionPeak& peak = (*peaks)[load]; peak.force > 0)
                places.push_back(std::clamp(peak.place, 0.0, 1.0));
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

}  // namespace

SectionForces largestForcesAt(const StringWaves& waves, std::size_t section, double xi, double endOfBlow,
                              double until) {
    const StringWaves::PiecePlace at = waves.pieceAt(section, xi);
    const SectionWaves& own = waves.pieces()[at.piece];
    PassingCells down(waves, own.downAt(at.xi)), up(waves, own.upAt(at.xi));
    SectionForces forces;
    for (const Load load : loads) forces[load].place = xi;
    const double same = waves.rounding(), end = std::min(waves.end(), until);
    for (double from = 0; from < end;) {
        const bool isAfter = from >= endOfBlow;
        SectionPeak& compression = isAfter ? forces.compressionAfter : forces.compression;
        SectionPeak& tension = isAfter ? forces.tensionAfter : forces.tension;
        const double to = std::min({down.next(), up.next(), end, isAfter ? end : endOfBlow});
        const double most = down.kept() * down.cell().most() + up.kept() * up.cell().most();
        const double least = down.kept() * down.cell().least() + up.kept() * up.cell().least();
        if (most > compression.force || -least > tension.force) {
            const WaveCell force = down.between(from, to) + up.between(from, to);
            note(compression, force, from, to);
            note(tension, -1 * force, from, to);
        }
        const bool fronts = std::max(down.next(), up.next()) <= std::min(to + same, end);
        const double downBefore = fronts ? down.between(from, to).end() : 0;
        const double upBefore = fronts ? up.between(from, to).end() : 0;
        down.advance(to + same);
        up.advance(to + same);
        const auto count = [&](double force) {
            note(compression, force, to);
            note(tension, -force, to);
        };
        // Where two fronts meet, one of them is first at the rear side of the place, the other at its front
        // side; what is outside of the section is not there.
        if (fronts && at.xi > 0) count(down.between(to, to).start() + upBefore);
        if (fronts && at.xi < 1) count(downBefore + up.between(to, to).start());
        from = to;
    }
    return forces;
}

std::vector<SectionEnvelope> stringEnvelope(const Impact& impact, const std::stop_token& stop,
                                            const EnvelopeGrid& grid) {
    assert(impact.waves);
    const StringWaves& waves = *impact.waves;
    std::vector<double> transitTimes(waves.sections(), 0);
    double transitTime = 0;
    for (std::size_t j = 0; j < waves.sections(); ++j) {
        for (std::size_t i = waves.firstPiece(j); i < waves.firstPiece(j + 1); ++i)
            transitTimes[j] += waves.pieces()[i].transitTime;
        transitTime += transitTimes[j];
    }
    const double ofPlace = 2 * std::max<double>(1, static_cast<double>(waves.clocks().size()));
    const double places = std::min<double>(grid.places, static_cast<double>(grid.mostSteps) / ofPlace);
    std::vector<SectionEnvelope> envelope(waves.sections());
    for (std::size_t j = 0; j < waves.sections(); ++j) {
        const SectionForces* peaks = impact.sections.empty() ? nullptr : &impact.sections[j];
        const int count = std::max(grid.leastOfSection,
                                   static_cast<int>(std::ceil(places * transitTimes[j] / transitTime)));
        SectionEnvelope made;
        for (const double xi : placesOf(peaks, count)) {
            if (stop.stop_requested()) return envelope;
            SectionForces forces = largestForcesAt(waves, j, xi, impact.endOfBlow, impact.forcesEnd);
            // along a cone the largest stress is not that of the largest force
            if (peaks && waves.piecesOf(j) == 1)
                for (const Load load : loads) hold(forces[load], (*peaks)[load]);
            made.push_back(forces);
        }
        envelope[j] = std::move(made);
    }
    return envelope;
}

}  // namespace drillwave
