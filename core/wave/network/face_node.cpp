// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/face_node.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/wave/exact/first_zero.h"

namespace drillwave {

namespace {

using Powers = std::array<double, WaveCell::count>;

/// Closing speeds below that are rounding: the faces rest against each other without force [v0].
constexpr double stillSpeed = 1e-12;

/// Differences of this share of what they are taken of are rounding, and decide nothing.
constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();

/// A closing speed at a new contact that makes a jump worth a cut of the cells [v0].
constexpr double leastJump = 1e-6;

/// Nearer to its ends a cell is not cut.
constexpr double nearestCut = 1e-9;

constexpr double quietMargin = 1e-3;

bool isStill(const WaveCell& w) {
    return std::abs(w.mean()) + w.spread() <= stillSpeed;
}

}  // namespace

FaceNode::FaceNode(double impedance1, double impedance2, const NetworkFace& face)
    : m_impedance1(impedance1),
      m_impedance2(impedance2),
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
    const double of1 = 2 / m_impedance1, of2 = 2 / m_impedance2;
    const double size = of1 * (std::abs(f1.mean()) + f1.spread()) + of2 * (std::abs(b2.mean()) + b2.spread());
    for (int k = 0; k < WaveCell::count; ++k) {
        w.c[k] = of1 * f1.c[k] + of2 * b2.c[k];
        if (std::abs(w.c[k]) <= rounding * size) w.c[k] = 0;
    }
    return w;
}

void FaceNode::step(WaveCell& f1ToF2, WaveCell& b2ToB1, int index, double time, CutAt cutAt, CellJump& jump) {
    const WaveCell f1 = f1ToF2, b2 = b2ToB1;
    WaveCell force;
    const WaveCell w = closingSpeed(f1, b2);
    noteOpening(w, m_widths[index], time);
    if (!m_now.released) {
        if (quietForce(w, index, time, force))
            add(force, m_widths[index], time);
        else
            force = follow(w, m_widths[index], 1, time, cutAt, jump);
    }
    b2ToB1 = force - f1;
    f1ToF2 = force - b2;
}

FaceNodeState FaceNode::stateWithin(const WaveCell& f1, const WaveCell& b2, int index, double share,
                                    double time) const {
    if (m_now.released) return m_now;
    FaceNode copy(m_impedance1, m_impedance2, {m_stiffness, m_restrike});
    copy.m_now = m_now;
    CellJump none;
    copy.follow(closingSpeed(f1, b2), m_widths[index], share, time, CutAt::nothing, none);
    return copy.m_now;
}

/// The force over a whole cell in which the faces neither part nor meet. False, and nothing done, where they
/// may.
bool FaceNode::quietForce(const WaveCell& w, int index, double time, WaveCell& force) {
    const double width = m_widths[index];
    if (m_now.apart) {
        const bool leaves = w.most() < -quietMargin * w.spread();
        if (!leaves && m_now.gap <= width * (std::abs(w.mean()) + w.spread()) &&
            !(isStill(w) && m_now.gap == 0))
            return false;
        if (!isStill(w) || m_now.gap > 0) m_now.gap -= width * w.mean();
        return true;
    }
    if (m_stiffness) {
        double last = m_now.force;
        force = m_maps[index].follow(m_common * w, last);
        if (force.least() <= quietMargin * force.spread() || force.most() > m_now.record.peakForce)
            return false;
        m_now.force = last;
    } else {
        if (w.least() <= quietMargin * w.spread() || w.least() <= stillSpeed) return false;
        force = m_common * w;
        if (force.most() > m_now.record.peakForce) {
            const WaveCell::Peak peak = force.peak();
            notePeak(peak.value, time + peak.place * width);
        }
    }
    return true;
}

void FaceNode::add(const WaveCell& force, double width, double time) {
    m_now.record.impulse += width * force.mean();
    m_now.record.impulseMoment += width * (time * force.mean() + width * force.firstMoment());
}

void FaceNode::notePeak(double force, double time) {
    if (force <= m_now.record.peakForce) return;
    m_now.record.peakForce = force;
    m_now.record.peakTime = time;
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

/// From contact to contact.
WaveCell FaceNode::follow(const WaveCell& w, double width, double share, double time, CutAt cutAt,
                          CellJump& jump) {
    constexpr int mostPieces = 10'000, mostStanding = 4;
    const Powers powers = w.powers();
    CellProjection projection;
    SearchCount uncounted;
    double from = 0;
    int standing = 0;  // events at one point
    if (!m_now.apart && !m_stiffness && isStill(w)) separate(time);
    for (int pieces = 0; from < share && !m_now.released; ++pieces) {
        if (pieces == mostPieces) {
            m_trouble = "the faces of hammer and string meet and part without end";
            break;
        }
        ++m_pieces;
        double length = share - from;
        std::array<double, RelaxationPiece::capacity + 1> watched{};  // gap, closing speed or force
        int count = 0;
        if (m_now.apart || !m_stiffness) {
            const Powers speed = seenFrom(powers, from, length);
            if (m_now.apart) {
                watched[0] = m_now.gap;
                for (int k = 0; k < WaveCell::count; ++k)
                    watched[k + 1] = -length * width * speed[k] / (k + 1);
                count = WaveCell::count + 1;
            } else {
                std::copy(speed.begin(), speed.end(), watched.begin());
                count = WaveCell::count;
            }
        } else {
            Powers target = powers;
            for (double& coefficient : target) coefficient *= m_common;
            const RelaxationPiece series = relaxationPiece(target, rate() * width, m_now.force, from);
            const double ratio = std::min(1.0, length / series.width);
            length = ratio * series.width;
            count = series.count;
            double power = 1;
            for (int k = 0; k < count; ++k, power *= ratio) watched[k] = power * series.c[k];
        }
        Zero<double> event;  // what balances at the point of contact stays there
        if (standing <= mostStanding) event = firstZero(watched.data(), count, 1.0, uncounted);
        if (event.undecided) m_trouble = "a contact of hammer and string cannot be placed";
        const double end = event.found ? event.u : 1;
        const double to = event.found || from + length < share ? from + end * length : share;
        const auto valueAt = [&](double v) {
            double sum = 0;
            for (int k = count - 1; k >= 0; --k) sum = sum * v + watched[k];
            return sum;
        };
        if (m_now.apart) {
            m_now.gap = event.found ? 0 : valueAt(1);
        } else if (to > from) {
            const double factor = m_stiffness ? 1 : m_common;
            CellProjection piece;
            const auto force = [&](double u) { return factor * valueAt((u - from) / length); };
            piece.add(from, to, force);
            projection.add(from, to, force);
            add(piece.cell(), width, time);
            m_now.force = factor * valueAt(end);
            notePeak(factor * valueAt(0), time + from * width);
            notePeak(m_now.force, time + to * width);
            if (m_stiffness) {
                PowerSeries<double> slope;
                slope.length = slope.scale = end;
                slope.count = count - 1;
                double power = 1;
                for (int k = 0; k + 1 < count; ++k, power *= end)
                    slope.c[k] = (k + 1) * watched[k + 1] * power;
                forEachMaximum(slope, end,
                               [&](double v) { notePeak(valueAt(v), time + (from + v * length) * width); });
            }
        }
        bool jumps = false;
        if (event.found && m_now.apart) {
            m_now.apart = false;
            m_now.force = 0;
            const double speed = w.value(to);
            const bool rises = !m_stiffness || rate() * width * (1 - to) > 0.4;
            jumps = rises && speed > leastJump;
        } else if (event.found) {
            separate(time + to * width);
            if (m_now.record.firstSeparation < 0) m_now.record.firstSeparation = time + to * width;
        }
        if (event.found && !jump.found && to > nearestCut && to < 1 - nearestCut &&
            (cutAt == CutAt::corners || (cutAt == CutAt::jumps && jumps)))
            jump = {true, to};
        standing = to > from ? 0 : standing + 1;
        from = to;
    }
    return projection.cell();
}

}  // namespace drillwave
