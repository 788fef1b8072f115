// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/drilling/rear_node.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numeric/first_zero.h"
#include "core/text/message.h"
#include "core/wave/network/relaxation.h"
#include "core/wave/network/wave_cell.h"

namespace drillwave {

namespace {

/// Terms of a series over a stretch on which nothing follows faster than half of it: 0.5^13/13! is rounding.
constexpr int termsOfMotion = 14;
constexpr double mostOfRate = 0.5;

/// Stretches of a cell at most: where rates need more, the cells are too long for them.
constexpr int mostStretches = 2000;

/// Differences of this share of what they are taken of are rounding, and decide nothing.
constexpr double roundingShare = 256 * std::numeric_limits<double>::epsilon();

double sizeOf(const double* c, int count) {
    double size = 0;
    for (int k = 0; k < count; ++k) size = std::max(size, std::abs(c[k]));
    return size;
}

/// The least value of a wave, where its bound does not do.
double leastOf(const WaveCell& wave) {
    return -(-1.0 * wave).peak().value;
}

/// Whether a series begins at zero or above and does not fall below it at once.
bool beginsPositive(const double* c, int count) {
    for (int k = 0; k < count; ++k)
        if (c[k] != 0) return c[k] > 0;
    return true;
}

}  // namespace

RearNode::RearNode(const Parts& parts, std::span<const double> widths)
    : m_parts(parts),
      m_machine(parts.machine),
      m_widths(widths.begin(), widths.end()),
      m_mobility(1 / parts.impedance) {
    const double mobility = 1 / parts.impedance + (parts.hammerImpedance > 0 ? 1 / parts.hammerImpedance : 0);
    if (parts.face.stiffness) m_fastest += *parts.face.stiffness * mobility;
    if (!m_machine) return;
    const double body = m_ofMass = 1 / m_machine->mass;
    m_fastest +=
        m_machine->damping * body + std::sqrt(m_machine->stiffness * body) + m_machine->stiffness * mobility;
    for (const double width : m_widths)
        if (m_fastest * width / mostOfRate > mostStretches)
            m_failureReason =
                translatable("the damper, or the face of the hammer, is too stiff for the time step");
    if (!m_failureReason.empty()) return;
    for (const double width : m_widths) m_maps.push_back(pressingMap(width));
}

void RearNode::beginBlow(double meanForce) {
    m_meanForce = meanForce;
    m_sums = {};
    m_before = m_now;
    if (m_parts.hammerImpedance == 0) return;
    m_now.faceGap = m_now.faceForce = 0;
    m_now.released = m_now.separated = false;
    m_now.touching = true;
}

/// From `from` on in these modes, as far as the series carries.
RearNode::Piece RearNode::pieceOf(const Inputs& in, const Modes& modes, double from, double end,
                                  const RearState& start, double meanForce) const {
    Piece piece;
    piece.modes = modes;
    piece.from = from;
    piece.width = end - from;
    const bool isElastic = modes.face == Face::touching && m_parts.face.stiffness;
    const double rate = m_fastest * in.width * piece.width;
    piece.count = m_machine || isElastic ? termsOf(rate) : WaveCell::count;
    if (rate > mostOfRate) piece.width = mostOfRate / (m_fastest * in.width);
    const double width = piece.width * in.width;
    const Powers f1 = seenFrom(in.f1, from, piece.width), b2 = seenFrom(in.b2, from, piece.width);
    const Powers force = seenFrom(in.force, from, piece.width);
    const double damping = m_machine ? m_machine->damping : 0;
    const double stiffness = m_machine ? m_machine->stiffness : 0;
    const double impedance = m_parts.impedance + (modes.pressing ? damping : 0);
    const double of1 = m_parts.hammerImpedance > 0 ? 2 / m_parts.hammerImpedance : 0;
    const double common = 1 / (of1 / 2 + 1 / impedance);
    piece.body[0] = start.bodyVelocity;
    piece.stretch[0] = start.stretch;
    piece.gap[0] = start.faceGap;
    if (isElastic) piece.push[0] = start.faceForce;
    for (int k = 0; k < piece.count; ++k) {
        const auto wave = [k](const Powers& p) { return k < WaveCell::count ? p[k] : 0; };
        const double step = width / (k + 1);
        const double mean = k == 0 ? meanForce : 0;
        const double pull = mean + stiffness * piece.stretch[k] + damping * piece.body[k];
        const double pressed = modes.pressing ? pull : 0;
        if (modes.face == Face::given) piece.push[k] = wave(force);
        if (modes.face == Face::touching && !isElastic)
            piece.push[k] = common * (of1 * wave(f1) + (2 * wave(b2) - pressed) / impedance);
        piece.rear[k] = (piece.push[k] + pressed - 2 * wave(b2)) / impedance;
        const double damper = pull - damping * piece.rear[k];
        piece.damper[k] = modes.pressing ? damper : 0;
        piece.margin[k] = modes.pressing ? damper : -damper;
        const double opening = piece.rear[k] - of1 * wave(f1) + of1 / 2 * piece.push[k];
        if (k + 1 == capacity) break;
        if (m_machine) {
            piece.body[k + 1] = step * (mean - piece.damper[k]) / m_machine->mass;
            piece.stretch[k + 1] = step * (piece.body[k] - piece.rear[k]);
        }
        if (modes.face == Face::apart) piece.gap[k + 1] = step * opening;
        if (isElastic && k + 1 < piece.count) piece.push[k + 1] = -*m_parts.face.stiffness * step * opening;
    }
    // what is left of differences decides nothing
    const double size =
        std::abs(meanForce) + stiffness * sizeOf(piece.stretch.data(), piece.count) +
        damping * (sizeOf(piece.body.data(), piece.count) + sizeOf(piece.rear.data(), piece.count));
    dropRounding(piece.margin.data(), piece.count, roundingShare * size);
    const double waves = sizeOf(b2.data(), WaveCell::count) + sizeOf(f1.data(), WaveCell::count) + size;
    if (modes.face == Face::touching) dropRounding(piece.push.data(), piece.count, roundingShare * waves);
    if (modes.face == Face::apart)
        dropRounding(piece.gap.data() + 1, piece.count,
                     roundingShare * width * waves * (of1 + 1 / impedance));
    return piece;
}

/// Whether nothing of what these modes suppose is wrong from the start.
bool RearNode::isConsistent(const Piece& piece) const {
    if (piece.modes.face == Face::touching && !beginsPositive(piece.push.data(), piece.count)) return false;
    if (piece.modes.face == Face::apart && !beginsPositive(piece.gap.data(), piece.count + 1)) return false;
    return !m_machine || beginsPositive(piece.margin.data(), piece.count);
}

/// Terms of a series over a stretch in which nothing follows faster than that, until they are rounding. A
/// string spends most of its time here, since its waves are seldom quiet; a rod always takes the same number.
int RearNode::termsOf(double rate) const {
    if (m_parts.hammerImpedance == 0) return termsOfMotion;
    int count = WaveCell::count + 1;
    for (double term = rate; term > roundingShare / 256 && count < termsOfMotion; ++count)
        term *= rate / (count - WaveCell::count + 1);
    return count;
}

RearNode::Piece RearNode::nextPiece(const Inputs& in, double from, double end) const {
    const bool given = m_parts.hammerImpedance == 0 || m_now.released;
    Piece piece;
    for (const Face face : {Face::given, Face::touching, Face::apart}) {
        if (given != (face == Face::given)) continue;
        if (face == Face::touching && (m_now.faceGap > 0 || (!m_now.touching && m_now.faceForce < 0)))
            continue;
        for (const bool pressing : {true, false}) {
            if (!pressing && !m_machine) continue;
            piece = pieceOf(in, {pressing, face}, from, end, m_now, m_meanForce);
            if (isConsistent(piece)) return piece;
        }
    }
    return piece;  // what balances there changes nothing
}

RearNode::PressingMap RearNode::pressingMap(double width) const {
    PressingMap map;
    for (int input = 0; input < PressingMap::inputs; ++input) {
        std::array<double, PressingMap::inputs> unit{};
        unit[static_cast<std::size_t>(input)] = 1;
        const auto& [meanForce, third, second, first, stretch, bodyVelocity, mean] = unit;
        const Inputs in{{}, {}, WaveCell{{mean, first, second, third}}.powers(), width};
        RearState state;
        state.bodyVelocity = bodyVelocity;
        state.stretch = stretch;
        CellProjection damper;
        for (double from = 0; from < 1;) {
            const Piece piece = pieceOf(in, {true, Face::given}, from, 1, state, meanForce);
            const double to = from + piece.width < 1 ? from + piece.width : 1;
            damper.add(from, to, [&](double u) {
                return polynomialValue(piece.damper.data(), piece.count, (u - from) / piece.width);
            });
            state.bodyVelocity = polynomialValue(piece.body.data(), piece.count, 1.0);
            state.stretch = polynomialValue(piece.stretch.data(), piece.count, 1.0);
            from = to;
        }
        auto& of = map.of[static_cast<std::size_t>(input)];
        std::ranges::copy(damper.cell().c, of.begin());
        of[WaveCell::count] = state.stretch;
    }
    return map;
}

/// A whole cell in which P is known and the damper presses or lifts all the way. False, and nothing done,
/// where it may not.
bool RearNode::quietStep(const WaveCell& b2, double width, std::size_t part, Forces& forces) {
    const WaveCell q = forces.face - 2.0 * b2;
    const double mean = m_meanForce, velocity = m_now.bodyVelocity, stretch = m_now.stretch;
    const double damping = m_machine->damping, stiffness = m_machine->stiffness;
    const double size = std::abs(mean), gain = width * m_ofMass;
    // where it lifts, S + κ x + ζ v_b less ζ v_r stays below zero
    const double moved = width * ((std::abs(velocity) + gain * size) + q.largest() * m_mobility);
    const double grows = stiffness * moved + damping * gain * size;
    const double pull = mean + stiffness * stretch + damping * velocity;
    WaveCell& damper = forces.damper;
    const double lowest = pull + grows + quietMargin * grows + roundingShare * size;
    const double ofQ = damping * m_mobility;
    bool lifts = lowest < ofQ * q.least();
    std::array<double, PressingMap::outputs> out{};
    if (!lifts) {
        const std::array<double, PressingMap::inputs> in{mean,    q.c[3],   q.c[2], q.c[1],
                                                         stretch, velocity, q.c[0]};
        const PressingMap& map = m_maps[part];
        for (std::size_t i = 0; i < in.size(); ++i)
            for (std::size_t k = 0; k < out.size(); ++k) out[k] += map.of[i][k] * in[i];
        std::copy_n(out.begin(), WaveCell::count, damper.c.begin());
        const double margin = quietMargin * damper.spread() + roundingShare * size;
        if (damper.least() <= margin) {
            // waves of a string are uneven: what they are at least is worth to be known
            if (m_parts.hammerImpedance == 0) return false;
            lifts = lowest < ofQ * leastOf(q);
            if (!lifts && leastOf(damper) <= margin) return false;
        }
    }
    if (lifts) {
        damper = {};
        m_now.stretch += width * (velocity + gain * mean / 2 - q.mean() * m_mobility);
    } else {
        m_now.stretch = out[WaveCell::count];
        if (damper.most() > m_sums.damperPeak)
            m_sums.damperPeak = std::max(m_sums.damperPeak, damper.peak().value);
        m_sums.damperImpulse += width * damper.mean();
        m_sums.workOnRear += width * m_mobility * damper.meanProduct(q + damper);
    }
    accelerate(gain * (mean - damper.mean()));
    return true;
}

/// Adds to v_b, and keeps what is lost in that.
void RearNode::accelerate(double velocityChange) {
    const double more = velocityChange - m_now.velocityRest;
    const double sum = m_now.bodyVelocity + more;
    m_now.velocityRest = (sum - m_now.bodyVelocity) - more;
    m_now.bodyVelocity = sum;
}

/// Whether the gap to the hammer is wider than both can move over a cell.
bool RearNode::staysApart(const WaveCell& f1, const WaveCell& b2, double width) {
    const double of1 = 2 / m_parts.hammerImpedance, impedance = m_parts.impedance;
    double push = std::abs(m_meanForce);
    if (m_machine)
        push += m_machine->stiffness * std::abs(m_now.stretch) +
                m_machine->damping * (std::abs(m_now.bodyVelocity) + 2 * b2.largest() / impedance);
    return m_now.faceGap > 2 * width * (of1 * f1.largest() + (2 * b2.largest() + push) / impedance);
}

RearNode::Forces RearNode::push(const WaveCell& f1, const WaveCell& b2, const WaveCell* force,
                                std::size_t part) {
    const double width = m_widths[part];
    Forces forces{force ? *force : WaveCell(), WaveCell::constant(m_meanForce)};
    if ((hasHammer() && !staysApart(f1, b2, width)) || (m_machine && !quietStep(b2, width, part, forces)))
        return follow({f1.powers(), b2.powers(), forces.face.powers(), width});
    if (force) {
        m_sums.forceWork += width * m_mobility * force->meanProduct(forces.sum() - 2.0 * b2);
        m_sums.faceImpulse += width * force->mean();
    }
    if (hasHammer()) {
        const double rear = m_mobility * (forces.damper.mean() - 2 * b2.mean());
        m_now.faceGap += width * (rear - 2 / m_parts.hammerImpedance * f1.mean());
        separate();
    }
    return forces;
}

/// Balances the work of machine and damper, which follows from the states at both ends of the cycle.
void RearNode::endCycle(double duration, double rearMoved) {
    if (!m_machine) {
        m_sums.damperImpulse = m_meanForce * duration;
        m_sums.damperPeak = std::max(0.0, m_meanForce);
        m_sums.feedWork = m_meanForce * rearMoved;
        return;
    }
    const double velocity = m_now.bodyVelocity, before = m_before.bodyVelocity;
    m_sums.feedWork = m_meanForce * (rearMoved + m_now.stretch - m_before.stretch);
    m_sums.damperWork =
        m_sums.feedWork - m_machine->mass * (velocity - before) * (velocity + before) / 2 - m_sums.workOnRear;
}

void RearNode::separate() {
    if (!hasHammer()) return;
    m_now.separated = true;
    if (!m_parts.face.restrike) m_now.released = true;
}

/// Adds impulse and work of the damper over the first `end` of a piece of width `unit`.
void RearNode::addDamper(const Piece& piece, double end, double unit) {
    const auto damperAt = [&](double v) { return polynomialValue(piece.damper.data(), piece.count, v); };
    double peak = std::max(damperAt(0), damperAt(end));
    const GaussRule& rule = gaussRule();
    for (std::size_t i = 0; i < GaussRule::count; ++i) {
        const double v = end * rule.nodes[i], damper = damperAt(v);
        m_sums.workOnRear +=
            unit * end * rule.weights[i] * damper * polynomialValue(piece.rear.data(), piece.count, v);
        peak = std::max(peak, damper);
    }
    m_sums.damperPeak = std::max(m_sums.damperPeak, peak);
}

/// From event to event.
RearNode::Forces RearNode::follow(const Inputs& in) {
    enum class Event { none, damper, face };
    WaveCell push, damper, rear;
    double from = 0;
    int standing = 0;
    bool touches = false;  // for a while in this cell
    SearchCount uncounted;
    for (int pieces = 0; from < 1 && m_failureReason.empty(); ++pieces) {
        if (pieces == mostStretches) {
            m_failureReason =
                translatable("the contact of damper or hammer with the rear end changes without end");
            break;
        }
        const Piece piece = nextPiece(in, from, 1);
        double end = 1;
        Event event = Event::none;
        const auto meet = [&](Event kind, const Series& c, int count) {
            const auto zero = firstZero(c.data(), count, end, uncounted);
            if (zero.undecided) m_failureReason = translatable("an event at the rear end cannot be placed");
            if (zero.found && (zero.u < end || event == Event::none)) end = zero.u, event = kind;
        };
        if (standing <= mostStanding) {
            if (m_machine) meet(Event::damper, piece.margin, piece.count);
            if (piece.modes.face == Face::touching) meet(Event::face, piece.push, piece.count);
            if (piece.modes.face == Face::apart) meet(Event::face, piece.gap, piece.count + 1);
        }
        const bool found = event != Event::none;
        const double to = found || from + piece.width < 1 ? from + end * piece.width : 1;
        const auto value = [&](const Series& c, double v) {
            return polynomialValue(c.data(), piece.count, v);
        };
        const auto local = [&](double u) { return (u - piece.from) / piece.width; };
        if (to > from) {
            CellProjection of[3];
            of[0].add(from, to, [&](double u) { return value(piece.push, local(u)); });
            of[1].add(from, to, [&](double u) { return value(piece.damper, local(u)); });
            of[2].add(from, to, [&](double u) { return value(piece.rear, local(u)); });
            const double impulse = in.width * of[0].cell().mean();
            m_sums.faceImpulse += impulse;
            if (m_now.separated) m_sums.lateImpulse += impulse;
            const double damped = of[1].cell().mean();
            push += of[0].cell(), damper += of[1].cell(), rear += of[2].cell();
            if (m_machine) {
                addDamper(piece, end, piece.width * in.width);
                const double ofDamper = in.width * damped;
                m_sums.damperImpulse += ofDamper;
                accelerate(m_ofMass * (in.width * m_meanForce * (to - from) - ofDamper));
            }
        }
        m_now.stretch = value(piece.stretch, end);
        if (piece.modes.face == Face::touching) {
            touches = touches || to > from;
            m_now.touching = true;
            m_now.faceGap = 0;
            m_now.faceForce = m_parts.face.stiffness ? std::max(0.0, value(piece.push, end)) : 0;
            if (event == Event::face) {
                m_now.faceForce = 0;
                m_now.touching = false;
            }
        } else if (piece.modes.face == Face::apart) {
            m_now.touching = false;
            m_now.faceGap = event == Event::face
                                ? 0
                                : std::max(0.0, polynomialValue(piece.gap.data(), piece.count + 1, end));
        }
        standing = to > from ? 0 : standing + 1;
        from = to;
    }
    if (!m_now.touching && (!touches || m_parts.releasesAtOnce)) separate();
    m_sums.forceWork += in.width * push.meanProduct(rear);
    return {push, damper};
}

}  // namespace drillwave
