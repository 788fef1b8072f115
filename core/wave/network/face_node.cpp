// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/face_node.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numeric/first_zero.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

using Powers = WaveCell::Powers;

/// Closing speeds below that are rounding: the faces rest against each other without force [F0/Zr].
constexpr double stillSpeed = 2e-12;

/// Differences of this share of what they are taken of are rounding, and decide nothing.
constexpr double faceRounding = 64 * std::numeric_limits<double>::epsilon();

/// A closing speed at a new contact that makes a jump worth a cut of the cells [F0/Zr].
constexpr double leastFaceJump = 2e-6;

bool isStill(const WaveCell& w) {
    return w.largest() <= stillSpeed;
}

/// Fa over a cell, and what the cell leaves out of it in the square.
struct ForceOverCell {
    WaveCell cell;
    double energy = 0;  ///< ∫Fa² dt [F0² t0]
};

ForceOverCell over(const PulseForce& force, double time, double width) {
    ForceOverCell result;
    if (!(width > 0)) return result;
    CellProjection projection;
    auto segment = std::ranges::upper_bound(force.segments, time, {}, &PulseSegment::start);
    if (segment != force.segments.begin()) --segment;
    for (; segment != force.segments.end() && segment->start < time + width; ++segment) {
        const double from = std::max(time, segment->start) - segment->start;
        const double to = std::min(time + width - segment->start, segment->length);
        if (to <= from) continue;
        const double offset = segment->start - time;
        projection.add((offset + from) / width, (offset + to) / width,
                       [&](double u) { return segment->forceAt(u * width - offset); });
        result.energy += segment->energyOf(from, to - from);
    }
    result.cell = projection.cell();
    return result;
}

}  // namespace

FaceNode::FaceNode(double impedance1, double impedance2, const HammerFace& face)
    : m_impedance1(impedance1),
      m_impedance2(impedance2),
      m_of1(2 / impedance1),
      m_of2(2 / impedance2),
      m_common(impedance1 * impedance2 / (impedance1 + impedance2)),
      m_stiffness(face.stiffness),
      m_restrike(face.restrike) {}

void FaceNode::setWidths(const std::vector<double>& widths) {
    m_widths = widths;
    m_maps.clear();
    if (m_stiffness)
        for (const double width : widths) m_maps.emplace_back(rate() * width);
}

WaveCell FaceNode::closingSpeed(const WaveCell& f1, const WaveCell& b2) const {
    WaveCell w;
    const double size = m_of1 * f1.largest() + m_of2 * b2.largest();
    for (int k = 0; k < WaveCell::count; ++k) w.c[k] = m_of1 * f1.c[k] + m_of2 * b2.c[k];
    dropRounding(w.c.data(), WaveCell::count, faceRounding * size);
    return w;
}

void FaceNode::step(const Waves& waves, int index, double time, CutAt cutAt, CellJump& jump) {
    const auto& [f1, b2, b1, f2] = waves;
    if (m_now.apart && m_now.record.firstSeparation >= 0 && staysApart(f1, b2, m_widths[index])) {
        b1 = -1.0 * f1;
        f2 = -1.0 * b2;
        return;
    }
    WaveCell force;
    const WaveCell w = closingSpeed(f1, b2);
    noteOpening(w, m_widths[index], time);
    if (!m_now.released) {
        if (quietForce(w, index, force))
            add(force, m_widths[index], time);
        else
            force = follow(w, m_widths[index], time, cutAt, jump);
    }
    b1 = force - f1;
    f2 = force - b2;
}

/// Whether the gap is wider than the faces can move over a cell, whatever the waves do in it: then it
/// changes.
bool FaceNode::staysApart(const WaveCell& f1, const WaveCell& b2, double width) {
    if (m_now.released) return true;
    const double most = m_of1 * f1.largest() + m_of2 * b2.largest();
    if (m_now.gap <= width * most) return false;
    m_now.gap -= width * (m_of1 * f1.mean() + m_of2 * b2.mean());
    return true;
}

FaceNode::Part FaceNode::partOfStep(const WaveCell& f1, const WaveCell& b2, int index, double share,
                                    double time) const {
    if (share <= 0) return {m_now, {}, {}};
    FaceNode copy(m_impedance1, m_impedance2, {m_stiffness, m_restrike});
    copy.m_now = m_now;
    const WaveCell first1 = f1.part(0, share), first2 = b2.part(0, share);
    WaveCell force;
    CellJump none;
    if (!m_now.released)
        force =
            copy.follow(closingSpeed(first1, first2), m_widths[index] * share, time, CutAt::nothing, none);
    return {copy.m_now, force - first2, force - first1};
}

/// The force over a whole cell in which the faces neither part nor meet. False, and nothing done, where they
/// may.
bool FaceNode::quietForce(const WaveCell& w, int index, WaveCell& force) {
    const double width = m_widths[index];
    if (m_now.apart) {
        const bool leaves = w.most() < -quietMargin * w.spread();
        if (!leaves && m_now.gap <= width * w.largest() && !(isStill(w) && m_now.gap == 0)) return false;
        if (!isStill(w) || m_now.gap > 0) m_now.gap -= width * w.mean();
        return true;
    }
    if (m_stiffness) {
        double last = m_now.force;
        force = m_maps[index].follow(m_common * w, last);
        if (force.least() <= quietMargin * force.spread()) return false;
        m_now.force = last;
    } else {
        if (w.least() <= quietMargin * w.spread() || w.least() <= stillSpeed) return false;
        force = m_common * w;
    }
    return true;
}

void FaceNode::add(const WaveCell& force, double width, double time) {
    m_now.record.impulse += width * force.mean();
    m_now.record.impulseMoment += width * (time * force.mean() + width * force.firstMoment());
}

/// After their force has gone the faces rest against each other until a wave moves them.
void FaceNode::noteOpening(const WaveCell& w, double width, double time) {
    if (!m_now.apart || m_now.record.firstSeparation >= 0 || isStill(w)) return;
    const Powers speed = w.powers();
    SearchCount uncounted;
    const auto zero = firstZero(speed.data(), WaveCell::count, 1.0, uncounted);
    if (zero.found)
        m_now.record.firstSeparation = time + zero.u * width;
    else if (m_now.released)  // what pushes now meets no hammer
        m_now.record.firstSeparation = m_now.record.firstRelease;
}

void FaceNode::separate(double time) {
    m_now.apart = true;
    m_now.gap = 0;
    m_now.force = 0;
    if (m_now.record.firstRelease < 0) m_now.record.firstRelease = time;
    if (!m_restrike) m_now.released = true;
}

/// Gap while apart, else force, over a stretch of a cell, as powers of 0 ≤ v ≤ 1: positive until an event
/// happens.
struct FaceNode::EventPiece {
    double from = 0, width = 1;  ///< in the width of the cell
    int count = 0;
    std::array<double, RelaxationPiece::capacity> c{};

    double value(double v) const { return polynomialValue(c.data(), count, v); }
};

FaceNode::EventPiece FaceNode::nextPiece(const Powers& w, double width, double from, double end) const {
    EventPiece piece = stretch(w, width, from, end);
    // Where a wave changes its sign it is zero, not what rounding leaves: else the faces part and meet there.
    double size = 0;
    for (const double coefficient : piece.c) size += std::abs(coefficient);
    dropRounding(piece.c.data(), piece.count, faceRounding * size);
    return piece;
}

FaceNode::EventPiece FaceNode::stretch(const Powers& w, double width, double from, double end) const {
    EventPiece piece;
    piece.from = from;
    piece.width = end - from;
    if (m_now.apart) {
        const Powers speed = seenFrom(w, from, piece.width);
        piece.count = WaveCell::count + 1;
        piece.c[0] = m_now.gap;
        for (int k = 0; k < WaveCell::count; ++k) piece.c[k + 1] = -piece.width * width * speed[k] / (k + 1);
        return piece;
    }
    Powers force = w;  // that of rigid faces, which the others follow
    for (double& coefficient : force) coefficient *= m_common;
    if (m_stiffness) {
        const RelaxationPiece series = relaxationPiece(force, rate() * width, m_now.force, from, end);
        piece.width = series.width;
        piece.count = series.count;
        std::copy_n(series.c.begin(), series.count, piece.c.begin());
    } else {
        force = seenFrom(force, from, piece.width);
        piece.count = WaveCell::count;
        std::copy(force.begin(), force.end(), piece.c.begin());
    }
    return piece;
}

/// From contact to contact.
WaveCell FaceNode::follow(const WaveCell& w, double width, double time, CutAt cutAt, CellJump& jump) {
    constexpr int mostPieces = 10'000;
    const Powers powers = w.powers();
    WaveCell total;
    SearchCount uncounted;
    double from = 0;
    int standing = 0;  // events at one point
    if (!m_now.apart && !m_stiffness && isStill(w)) separate(time);
    for (int pieces = 0; from < 1 && !m_now.released && m_failureReason.empty(); ++pieces, ++m_pieces) {
        if (pieces == mostPieces) {
            m_failureReason = translatable("the contact of hammer and string changes without end");
            break;
        }
        const EventPiece piece = nextPiece(powers, width, from, 1);
        Zero<double> event;
        if (standing <= mostStanding) event = firstZero(piece.c.data(), piece.count, 1.0, uncounted);
        if (event.undecided)
            m_failureReason = translatable("a contact of hammer and string cannot be placed");
        const double end = event.found ? event.u : 1;
        const double to = event.found || from + piece.width < 1 ? from + end * piece.width : 1;
        if (m_now.apart) {
            m_now.gap = event.found ? 0 : piece.value(1);
        } else if (to > from) {
            CellProjection force;
            force.add(from, to, [&](double u) { return piece.value((u - from) / piece.width); });
            add(force.cell(), width, time);
            total += force.cell();
            m_now.force = piece.value(end);
        }
        if (event.found && m_now.apart) {
            const bool rises = !m_stiffness || rate() * width * (1 - to) > fastRise;
            jump.offer(cutAt, rises && w.value(to) > leastFaceJump, to);
            m_now.apart = false;
            m_now.force = 0;
        } else if (event.found) {
            jump.offer(cutAt, false, to);
            separate(time + to * width);
            if (m_now.record.firstSeparation < 0) m_now.record.firstSeparation = time + to * width;
        }
        standing = to > from ? 0 : standing + 1;
        from = to;
    }
    return total;
}

WaveCell ForceNode::step(const WaveCell& back, double time, double width) {
    const double end = time + width;
    if (time < m_force->end) {
        const auto [force, energy] = over(*m_force, time, width);
        m_now.record.impulse += width * force.mean();
        m_now.record.impulseMoment += width * (time * force.mean() + width * force.firstMoment());
        m_now.record.work += (energy - 2 * width * force.meanProduct(back)) / m_impedance;
        m_now.apart = m_now.released = end >= m_force->end;
        return force - back;
    }
    m_now.apart = m_now.released = true;
    return -1 * back;
}

}  // namespace drillwave
