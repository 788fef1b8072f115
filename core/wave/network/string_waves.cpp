// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/string_waves.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace drillwave {

namespace {

bool isNothing(const WaveCell& cell) {
    return cell.mean() == 0 && cell.spread() == 0;
}

/// Puts cells of curves on the same pieces one behind the other, those in which there is nothing as one
/// piece.
template <std::size_t count>
class CurvesOfCells {
  public:
    CurvesOfCells(const std::array<PiecewisePolynomial*, count>& curves, double start) : m_curves(curves) {
        for (PiecewisePolynomial* curve : m_curves) curve->clear(start);
    }

    void add(const std::array<WaveCell, count>& cells, double width) {
        if (std::ranges::all_of(cells, isNothing)) {
            m_nothing += width;
            return;
        }
        finish();
        for (std::size_t i = 0; i < count; ++i) m_curves[i]->append(width, width, cells[i].powers());
    }
    void finish() {
        if (m_nothing > 0)
            for (PiecewisePolynomial* curve : m_curves) curve->append(m_nothing, m_nothing, {});
        m_nothing = 0;
    }

  private:
    std::array<PiecewisePolynomial*, count> m_curves;
    double m_nothing = 0;  ///< how long the last cells were zero
};

/// ∫ of a cell over the first `share` of it, in its width.
double integralOf(const WaveCell& cell, double share) {
    const WaveCell::Powers p = cell.powers();
    return share * (p[0] + share * (p[1] / 2 + share * (p[2] / 3 + share * p[3] / 4)));
}

double clockAt(const WaveAtPlace& wave, double t) {
    return t - wave.rearTime - wave.delay;
}

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

    /// Returns the wave between time and next().
    const WaveCell& cell() const { return m_behind == 0 ? m_first : m_cells[m_behind - 1]; }
    /// Returns the share of it left after the way from the end where it entered.
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

// The known peak is more exact than the waves that were kept.
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

WaveAtPlace SectionWaves::downAt(double xi) const {
    return {&down, first, rearTime, xi * transitTime, decay > 0 ? std::exp(-decay * xi) : 1};
}

WaveAtPlace SectionWaves::upAt(double xi) const {
    return {&up, -first, rearTime, (2 - xi) * transitTime, decay > 0 ? std::exp(-decay * (1 - xi)) : 1};
}

StringWaves::StringWaves(const Problem& problem, const std::vector<double>& rearTimes)
    : m_hammerPieces(problem.hammerSections()) {
    for (std::size_t j = 0; j < problem.sections.size(); ++j) {
        const UniformSection& section = problem.sections[j];
        m_pieces.push_back(
            {.impedance = section.impedance,
             .transitTime = section.transitTime,
             .decay = section.decay,
             .rearTime = rearTimes[j],
             .first = j < m_hammerPieces ? problem.hammer().velocity * section.impedance / 2 : 0,
             .down = {},
             .up = {}});
    }
    m_firstPieces.push_back(0);
    for (std::size_t j = 0; j < (problem.pieces.empty() ? problem.sections.size() : problem.pieces.size());
         ++j)
        m_firstPieces.push_back(m_firstPieces.back() +
                                static_cast<std::size_t>(problem.pieces.empty() ? 1 : problem.pieces[j]));
}

std::size_t StringWaves::hammerSections() const {
    return static_cast<std::size_t>(std::ranges::lower_bound(m_firstPieces, m_hammerPieces) -
                                    m_firstPieces.begin());
}

StringWaves::PiecePlace StringWaves::pieceAt(std::size_t section, double xi) const {
    assert(section < sections() && xi >= 0 && xi <= 1);
    const int count = piecesOf(section);
    const double at = xi * count;
    const double before = std::min(std::floor(at), count - 1.0);
    return {m_firstPieces[section] + static_cast<std::size_t>(before), at - before};
}

void StringWaves::addStep(double clock, double width, const WaveCell& bitForce, const WaveCell& rearForce) {
    m_clocks.push_back(clock);
    m_widths.push_back(width);
    m_bitForces.push_back(bitForce);
    if (m_hammerPieces == 0) m_rearForces.push_back(rearForce);
}

bool StringWaves::isFull() const {
    // two waves of every section; clock and width; the curves of face and bit
    const std::size_t ofStep = 2 * m_pieces.size() * sizeof(WaveCell) + 2 * sizeof(double) +
                               4 * (sizeof(PiecewisePolynomial::Piece) + sizeof(WaveCell) + sizeof(double));
    return m_clocks.size() * ofStep >= mostBytes;
}

void StringWaves::finish(double end) {
    m_end = end;
    makeCurves();
    m_bitForces = m_rearForces = m_damperForces = {};
    for (SectionWaves& section : m_pieces) {
        section.down.shrink_to_fit();
        section.up.shrink_to_fit();
    }
}

void StringWaves::makeCurves() {
    const SectionWaves& last = m_pieces.back();
    const double kept = std::exp(-last.decay), bitTime = last.rearTime + last.transitTime;
    const SectionWaves* hammer = m_hammerPieces > 0 ? &m_pieces[m_hammerPieces - 1] : nullptr;
    const double faceTime = hammer ? hammer->rearTime + hammer->transitTime : 0;
    const auto firstOf = [this](double zero) {
        return m_clocks.empty() ? zero : std::max(0.0, zero + begin());
    };
    CurvesOfCells<1> face({&m_faceForce}, firstOf(faceTime)), damper({&m_damperForce}, firstOf(faceTime));
    CurvesOfCells<3> bit({&m_bitForce, &m_bitWave, &m_bitVelocity}, firstOf(bitTime));
    // what of a step is behind the beginning of the blow
    const auto add = [this](auto& curves, double zero, std::size_t step, auto cells) {
        const double start = zero + m_clocks[step], width = m_widths[step];
        if (start + width <= rounding() && begin() < 0) return;
        const bool isWhole = start > -rounding() || begin() >= 0;
        if (!isWhole)
            for (WaveCell& cell : cells) cell = cell.part(-start / width, 1);
        curves.add(cells, isWhole ? width : start + width);
    };
    for (std::size_t i = 0; i < m_clocks.size(); ++i) {
        const WaveCell g = kept * last.down[i];
        add(face, faceTime, i, std::array{hammer ? hammer->down[i] + hammer->up[i] : m_rearForces[i]});
        if (!m_damperForces.empty()) add(damper, faceTime, i, std::array{m_damperForces[i]});
        add(bit, bitTime, i, std::array{m_bitForces[i], g, (1 / last.impedance) * (g - last.up[i])});
    }
    face.finish();
    damper.finish();
    bit.finish();
}

double StringWaves::rounding() const {
    // times are sums of some delays of the size of the last one
    return m_clocks.empty() ? 0 : 32 * std::numeric_limits<double>::epsilon() * (m_clocks.back() + m_end);
}

/// The step that a clock is in, not before the first.
std::size_t StringWaves::stepAt(double clock) const {
    const auto behind = std::upper_bound(m_clocks.begin(), m_clocks.end(), clock);
    return behind == m_clocks.begin() ? 0 : static_cast<std::size_t>(behind - m_clocks.begin()) - 1;
}

double StringWaves::value(const WaveAtPlace& wave, double t, TimeSide side) const {
    const double clock = clockAt(wave, t);
    const double reach = side == TimeSide::after ? rounding() : -rounding();
    if (m_clocks.empty() || clock + reach < begin()) return wave.first;
    const std::size_t step = stepAt(clock + reach);
    const double u = std::clamp((clock - m_clocks[step]) / m_widths[step], 0.0, 1.0);
    return wave.kept * (*wave.cells)[step].value(u);
}

WaveAtPlace StringWaves::downAt(std::size_t section, double xi) const {
    const PiecePlace at = pieceAt(section, xi);
    return m_pieces[at.piece].downAt(at.xi);
}

WaveAtPlace StringWaves::upAt(std::size_t section, double xi) const {
    const PiecePlace at = pieceAt(section, xi);
    return m_pieces[at.piece].upAt(at.xi);
}

double StringWaves::down(std::size_t section, double xi, double t, TimeSide side) const {
    return value(downAt(section, xi), t, side);
}

double StringWaves::up(std::size_t section, double xi, double t, TimeSide side) const {
    return value(upAt(section, xi), t, side);
}

double StringWaves::impulse(const WaveAtPlace& wave, double t) const {
    const auto until = [&](double clock) {  // from where the cells begin
        if (clock <= begin() || m_clocks.empty()) return wave.first * (clock - begin());
        const std::size_t last = stepAt(clock);
        double sum = 0;
        for (std::size_t i = 0; i < last; ++i) sum += m_widths[i] * (*wave.cells)[i].mean();
        const double share = std::min(1.0, (clock - m_clocks[last]) / m_widths[last]);
        return sum + m_widths[last] * integralOf((*wave.cells)[last], share);
    };
    return wave.kept * (until(clockAt(wave, t)) - until(clockAt(wave, 0)));
}

double StringWaves::downImpulse(std::size_t section, double xi, double t) const {
    return impulse(downAt(section, xi), t);
}

double StringWaves::upImpulse(std::size_t section, double xi, double t) const {
    return impulse(upAt(section, xi), t);
}

std::vector<double> StringWaves::pieceTimes(std::size_t section, double xi) const {
    std::vector<double> times{0, m_end};
    for (const double zero : {downAt(section, xi).zero(), upAt(section, xi).zero()})
        for (const double clock : m_clocks)
            if (const double t = zero + clock; t > 0 && t < m_end) times.push_back(t);
    std::sort(times.begin(), times.end());
    const double same = rounding();
    times.erase(std::unique(times.begin(), times.end(), [same](double a, double b) { return b - a <= same; }),
                times.end());
    return times;
}

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
