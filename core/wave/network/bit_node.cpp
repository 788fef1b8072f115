// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/bit_node.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/text/message.h"

namespace drillwave {

namespace {

using Powers = WaveCell::Powers;

/// Waves smaller than that make no jump worth a cut [F0].
constexpr double leastBitJump = 2e-7;

/// Differences of this share of what they are taken of are rounding, and decide nothing.
constexpr double bitRounding = 256 * std::numeric_limits<double>::epsilon();

double sumOf(const double* c, int count) {
    double sum = 0;
    for (int k = 0; k < count; ++k) sum += std::abs(c[k]);
    return sum;
}

}  // namespace

/// Motion of the bit over a piece of a cell, from event to event: power series in 0 ≤ v ≤ 1.
struct BitNode::EventPiece {
    static constexpr int capacity = OscillationPiece::capacity;
    double from = 0, width = 1;  ///< in the width of the cell
    int count = 0;               ///< of the force and of the speed; the distance has one more
    std::array<double, capacity> force, speed;
    std::array<double, capacity + 1> distance;

    double forceAt(double v) const { return polynomialValue(force.data(), count, v); }
    double speedAt(double v) const { return polynomialValue(speed.data(), count, v); }
    double distanceAt(double v) const { return polynomialValue(distance.data(), count + 1, v); }
};

BitNode::BitNode(double impedance, double mass, const BitRockLaw& law, double gap)
    : m_impedance(impedance),
      m_mass(mass),
      m_toSpeed(2 / impedance),
      m_untouched(law),
      m_now(m_untouched, gap) {}

void BitNode::setWidths(const std::vector<double>& widths) {
    m_mapsBefore.swap(m_maps);
    m_maps.clear();
    for (std::vector<CellMaps>* maps : {&m_maps, &m_mapsBefore}) maps->reserve(widths.size());
    for (const double width : widths) {
        const auto known = std::ranges::find(m_mapsBefore, width, &CellMaps::width);
        m_maps.push_back(known != m_mapsBefore.end() ? *known : mapsOf(width));
    }
}

BitNode::CellMaps BitNode::mapsOf(double width) const {
    CellMaps maps;
    maps.width = width;
    maps.loading = mapsOfLine(width);
    if (m_mass == 0) {
        maps.elastic = Relaxation(rateOn(ContactLine::elastic) * width);
    } else {
        maps.apart = Relaxation(m_impedance / m_mass * width);
        maps.elasticMass = Oscillation({m_impedance, m_mass, m_now.law.slopes().elastic}, width);
    }
    return maps;
}

/// Returns the maps of the loading line of the largest force.
BitNode::LineMaps BitNode::mapsOfLine(double width) const {
    LineMaps maps;
    maps.line = m_now.law.loadingLine();
    if (m_mass == 0)
        maps.free = Relaxation(rateOn(ContactLine::primary) * width);
    else
        maps.mass = Oscillation({m_impedance, m_mass, m_now.law.slopes().primary}, width);
    return maps;
}

/// They change with a corner only, and that is passed once.
const BitNode::LineMaps& BitNode::loadingMaps(CellMaps& maps) const {
    if (maps.loading.line != m_now.law.loadingLine()) maps.loading = mapsOfLine(maps.width);
    return maps.loading;
}

double BitNode::fastestRate() const {
    if (m_mass == 0) return rateOn(ContactLine::elastic);
    return OscillationRates{m_impedance, m_mass, m_now.law.slopes().elastic}.fastest();
}

void BitNode::addRates(std::vector<double>& rates) const {
    if (m_mass == 0) {
        rates.push_back(rateOn(ContactLine::primary));
    } else {
        rates.push_back(m_impedance / m_mass);
        rates.push_back(OscillationRates{m_impedance, m_mass, m_now.law.slopes().primary}.fastest());
    }
    rates.push_back(fastestRate());
}

void BitNode::step(const WaveCell& g, WaveCell& b, int index, double time, CutAt cutAt, CellJump& jump) {
    CellMaps& maps = m_maps[index];
    if (!quietStep(g, maps, time, b)) b = follow(g, maps.width, time, cutAt, jump);
}

bool BitNode::fly(const WaveCell& g, double width) {
    const bool leaves = g.most() < -quietMargin * g.spread();
    if (!leaves && m_now.distance <= width * (m_toSpeed * g.largest())) return false;
    m_now.distance -= width * (m_toSpeed * g.mean());
    return true;
}

BitNode::Part BitNode::partOfStep(const WaveCell& g, int index, double share, double time) const {
    if (share <= 0) return {m_now, {}};
    BitNode copy(m_impedance, m_mass, {}, 0);
    copy.m_now = m_now;
    CellJump none;
    const WaveCell leaving =
        copy.follow(g.part(0, share), m_maps[index].width * share, time, CutAt::nothing, none);
    return {copy.m_now, leaving};
}

/// A whole cell in which nothing happens. False, and nothing done, where something may.
bool BitNode::quietStep(const WaveCell& g, CellMaps& maps, double time, WaveCell& b) {
    double velocity = m_now.velocity, force = m_now.force;
    WaveCell speeds, forces;
    if (m_now.isApart() && m_mass == 0) {
        if (!fly(g, maps.width)) return false;
        b = -1.0 * g;
        m_cellForce = {};
        return true;
    }
    if (m_now.isApart()) {
        speeds = maps.apart.follow(m_toSpeed * g, velocity);
        const bool leaves = speeds.most() < -quietMargin * speeds.spread();
        if (!leaves && m_now.distance <= maps.width * speeds.largest()) return false;
        m_now.distance -= maps.width * speeds.mean();
        m_now.velocity = velocity;
        b = g - m_impedance * speeds;
        m_cellForce = {};
        return true;
    }
    const bool primary = m_now.line == ContactLine::primary;
    if (m_mass == 0) {
        forces = (primary ? loadingMaps(maps).free : maps.elastic).follow(2.0 * g, force);
        speeds = 2.0 * g - forces;  // times Z: its sign is what counts
    } else {
        (primary ? loadingMaps(maps).mass : maps.elasticMass).follow(g, velocity, force, speeds, forces);
    }
    if (primary && m_now.law.hasCorner() &&
        forces.most() >= m_now.law.cornerForce() - quietMargin * forces.spread())
        return false;
    if (m_now.law.isOneWay(m_now.line)) {
        if (speeds.least() <= quietMargin * speeds.spread()) return false;
    } else {
        const double margin = quietMargin * forces.spread();
        if (forces.least() <= margin) return false;
        if (forces.most() >=
            (m_now.law.isElastic() ? m_now.record.peakForce : m_now.law.largestForce() - margin))
            return false;
    }
    m_now.force = force;
    m_now.velocity = velocity;
    if (primary) noteForce(force, time + maps.width);
    if (m_notesAllPeaks && forces.most() > m_now.record.peakForce) {
        const WaveCell::Peak peak = forces.peak();
        notePeak(peak.value, time + peak.place * maps.width);
    }
    m_now.record.impulse += maps.width * forces.mean();
    m_now.record.impulseMoment += maps.width * (time * forces.mean() + maps.width * forces.firstMoment());
    m_now.record.contactDuration += maps.width;
    b = m_mass > 0 ? g - m_impedance * speeds : forces - g;
    m_cellForce = forces;
    return true;
}

void BitNode::noteForce(double force, double time) {
    m_now.law.remember(force);
    notePeak(force, time);
}

void BitNode::notePeak(double force, double time) {
    if (force <= m_now.record.peakForce) return;
    m_now.record.peakForce = force;
    m_now.record.peakTime = time;
}

BitNode::Turned BitNode::beginCycle(bool isFresh) {
    Turned turned{.penetration = m_now.law.residualPenetration() - m_residual};
    if (isFresh) {
        const double givenBack = m_now.isApart() ? 0 : m_now.law.givenBack(m_now.force);
        putAt(placeFromBottom(), 0);
        turned.lostEnergy = givenBack - (m_now.isApart() ? 0 : m_now.law.worked(m_now.force));
    }
    m_residual = isFresh ? 0 : m_now.law.residualPenetration();
    m_now.record = {};
    m_now.record.peakForce = m_now.force;
    return turned;
}

void BitNode::putAt(double placeFromBottom, double largestForce) {
    ContactLaw<double> law = m_untouched;
    law.rememberAcross(largestForce);
    m_now.force = m_now.distance = 0;
    if (placeFromBottom <= 0) {
        m_now.line = ContactLine::apart;
        m_now.distance = -placeFromBottom;
    } else {
        m_now.force = law.force(law.residualPenetration() + placeFromBottom);
        m_now.line = law.lineAtContact();
        if (m_now.force >= law.largestForce()) {
            law.rememberAcross(m_now.force);
            m_now.line = ContactLine::primary;
        }
    }
    m_now.law = law;
}

void BitNode::separate(double time) {
    m_now.record.lastSeparation = time;
    m_now.force = 0;
    m_now.distance = 0;
}

void BitNode::touch(double time) {
    if (m_now.record.firstContact < 0) m_now.record.firstContact = time;
    m_now.record.lastContact = time;
    ++m_now.record.contacts;
    m_now.force = 0;
}

void BitNode::enter(const LineEvent& event, double time) {
    ContactEvent kind = ContactEvent::unloading;
    if (event.isCorner) {
        kind = ContactEvent::corner;
        m_now.law.passCorner();
        m_now.force = m_now.law.largestForce();
    } else if (event.line == ContactLine::apart) {
        kind = ContactEvent::separation;
        separate(time);
    } else if (m_now.isApart()) {
        kind = ContactEvent::contact;
        touch(time);
    } else if (event.line == ContactLine::primary) {
        kind = ContactEvent::primaryLoading;
        m_now.force = m_now.law.largestForce();
    }
    m_now.line = event.line;
    if (m_events) m_events->push_back({kind, time});
}

BitNode::EventPiece BitNode::nextPiece(const Powers& g, double width, double from, double end) const {
    EventPiece piece;
    piece.from = from;
    piece.width = end - from;
    piece.count = WaveCell::count;
    piece.force.fill(0);
    piece.speed.fill(0);
    if (m_mass == 0 && !m_now.isApart()) {
        Powers twice = g;
        for (double& coefficient : twice) coefficient *= 2;
        const RelaxationPiece series =
            relaxationPiece(twice, rateOn(m_now.line) * width, m_now.force, from, end);
        piece.width = series.width;
        piece.count = series.count;
        std::copy_n(series.c.begin(), series.count, piece.force.begin());
        const Powers wave = seenFrom(twice, from, piece.width);
        for (int k = 0; k < piece.count; ++k)
            piece.speed[k] = ((k < WaveCell::count ? wave[k] : 0) - piece.force[k]) / m_impedance;
        dropRounding(piece.speed.data(), piece.count,
                     bitRounding * sumOf(piece.force.data(), piece.count) / m_impedance);
    } else if (m_mass == 0) {
        const Powers wave = seenFrom(g, from, piece.width);
        for (int k = 0; k < WaveCell::count; ++k) piece.speed[k] = m_toSpeed * wave[k];
    } else if (m_now.isApart()) {
        Powers target = g;
        for (double& coefficient : target) coefficient *= m_toSpeed;
        const RelaxationPiece series =
            relaxationPiece(target, m_impedance / m_mass * width, m_now.velocity, from, end);
        piece.width = series.width;
        piece.count = series.count;
        std::copy_n(series.c.begin(), series.count, piece.speed.begin());
    } else {
        const OscillationRates rates{m_impedance, m_mass, m_now.law.slope(m_now.line)};
        piece.width = std::min(piece.width, 1 / (rates.fastest() * width));
        const OscillationPiece series = oscillationPiece(rates, seenFrom(g, from, piece.width),
                                                         piece.width * width, m_now.velocity, m_now.force);
        piece.count = OscillationPiece::capacity;
        piece.force = series.force;
        piece.speed = series.velocity;
    }
    piece.distance[0] = m_now.distance;
    for (int k = 0; k < piece.count; ++k)
        piece.distance[k + 1] = -piece.width * width * piece.speed[k] / (k + 1);
    return piece;
}

/// Returns the first event on a piece: its place, and the line after it. A state that balances on a corner of
/// the law should stay there: then it looks for no event.
BitNode::LineEvent BitNode::nextEvent(const EventPiece& piece) {
    LineEvent event{{}, m_now.line};
    SearchCount uncounted;
    const auto meet = [&](const double* c, int count, ContactLine line, bool isCorner = false) {
        const auto zero = firstZero(c, count, event.zero.found ? event.zero.u : 1.0, uncounted);
        if (zero.undecided) m_failureReason = translatable("an event at the rock cannot be placed");
        if (zero.found && (!event.zero.found || zero.u < event.zero.u)) event = {zero, line, isCorner};
    };
    const auto meetForce = [&](double force, bool isCorner) {
        std::array<double, EventPiece::capacity> below{};
        for (int k = 0; k < piece.count; ++k) below[k] = -piece.force[k];
        below[0] += force;
        dropRounding(below.data(), piece.count, bitRounding * force);
        meet(below.data(), piece.count, ContactLine::primary, isCorner);
    };
    if (m_now.isApart()) {
        meet(piece.distance.data(), piece.count + 1, m_now.law.lineAtContact());
        return event;
    }
    if (m_now.law.isOneWay(m_now.line)) {
        meet(piece.speed.data(), piece.count, ContactLine::elastic);
    } else {
        meet(piece.force.data(), piece.count, ContactLine::apart);
        if (!m_now.law.isElastic()) meetForce(m_now.law.largestForce(), false);
    }
    if (m_now.line == ContactLine::primary && m_now.law.hasCorner()) meetForce(m_now.law.cornerForce(), true);
    return event;
}

/// Adds what the rock feels over the first `end` of a piece; `unit` is the length of the piece, `time` when
/// it begins [t0].
void BitNode::addContact(const EventPiece& piece, double end, double unit, double time) {
    double sum = 0, moment = 0, power = end;
    for (int k = 0; k < piece.count; ++k, power *= end) {
        sum += piece.force[k] * power / (k + 1);
        moment += piece.force[k] * power * end / (k + 2);
    }
    m_now.record.contactDuration += end * unit;
    m_now.record.impulse += unit * sum;
    m_now.record.impulseMoment += unit * (time * sum + unit * moment);
    if (!m_now.law.isElastic() && !m_notesAllPeaks) return;
    SearchCount uncounted;  // the force has its maximum where the bit turns
    const auto top = firstZero(piece.speed.data(), piece.count, end, uncounted);
    if (top.found) noteForce(piece.forceAt(top.u), time + top.u * unit);
}

/// The state after the first `end` of a piece, at `time`.
void BitNode::moveAlong(const EventPiece& piece, double end, double time) {
    if (m_mass > 0) m_now.velocity = piece.speedAt(end);
    if (m_now.isApart()) {
        m_now.distance = piece.distanceAt(end);
        return;
    }
    m_now.force = piece.forceAt(end);
    if (m_now.line == ContactLine::primary) noteForce(m_now.force, time);
}

/// Where the bit turns on the primary line it stands still: rounding must not send it on.
void BitNode::restAt(double wave, double time) {
    m_now.velocity = 0;
    if (m_mass > 0) return;
    noteForce(2 * wave, time);
    m_now.force = m_now.law.largestForce();
}

/// From event to event.
WaveCell BitNode::follow(const WaveCell& g, double width, double time, CutAt cutAt, CellJump& jump) {
    constexpr int mostPieces = 30'000;
    const Powers powers = g.powers();
    CellProjection leaving, forces;
    double from = 0;
    int standing = 0;  // events at one point
    for (int pieces = 0; from < 1 && m_failureReason.empty(); ++pieces, ++m_pieces) {
        if (pieces == mostPieces) {
            m_failureReason = translatable(
                "bit and rock change contact, or a small bit mass oscillates, faster than can be computed");
            break;
        }
        const EventPiece piece = nextPiece(powers, width, from, 1);
        const LineEvent event = standing > mostStanding ? LineEvent{{}, m_now.line} : nextEvent(piece);
        const bool found = event.zero.found;
        const double end = found ? event.zero.u : 1;
        const double to = found || from + piece.width < 1 ? from + end * piece.width : 1;
        const double eventTime = time + to * width;
        const auto local = [&](double u) { return (u - piece.from) / piece.width; };
        if (to > from && m_mass > 0)
            leaving.add(from, to, [&](double u) { return -m_impedance * piece.speedAt(local(u)); });
        if (to > from && !m_now.isApart())
            forces.add(from, to, [&](double u) { return piece.forceAt(local(u)); });
        if (!m_now.isApart()) addContact(piece, end, piece.width * width, time + from * width);
        moveAlong(piece, end, eventTime);
        if (found) {
            const bool turns = m_now.law.isOneWay(m_now.line) && !event.isCorner && end > 0;
            const bool isJump = m_now.isApart() && fastestRate() * width * (1 - to) > fastRise &&
                                std::abs(piece.speedAt(end)) > leastBitJump;
            jump.offer(cutAt, isJump, to);
            enter(event, eventTime);
            if (turns) restAt(g.value(to), eventTime);
        }
        standing = to > from ? 0 : standing + 1;
        from = to;
    }
    m_cellForce = forces.cell();
    return m_mass > 0 ? g + leaving.cell() : m_cellForce - g;
}

}  // namespace drillwave
