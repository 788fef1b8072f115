// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/plain_lattice.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <vector>

#include "core/contact/contact_law.h"

namespace drillwave {

namespace {

/// y' = rate (target − y) over a step: its mean and its end.
struct Step {
    double mean, end;
};
Step follow(double y, double target, double rate, double step) {
    const double x = rate * step;
    const double kept = std::exp(-x);
    return {target + (y - target) * (x > 1e-8 ? -std::expm1(-x) / x : 1 - x / 2),
            target + (y - target) * kept};
}

/// The waves on their way back through a section, one for each cell.
class Ring {
  public:
    Ring(long count, double value) : m_values(static_cast<std::size_t>(count), value) {}
    double arriving() const { return m_values[m_at]; }
    void leave(double value) {
        m_values[m_at] = value;
        m_at = m_at + 1 == m_values.size() ? 0 : m_at + 1;
    }

  private:
    std::vector<double> m_values;
    std::size_t m_at = 0;
};

/// Bit and rock, from step to step.
class PlainBit {
  public:
    PlainBit(const Problem& problem)
        : m_impedance(problem.sections.back().impedance),
          m_mass(problem.sections.back().massAfter),
          m_law(problem.law),
          m_distance(problem.distance()) {}

    double step(double g, double step) {
        const double before = m_force;
        double speed = (2 * g - m_force) / m_impedance;
        if (m_mass > 0) {
            const Step v = follow(m_velocity, speed, m_impedance / m_mass, step);
            speed = v.mean;
            m_velocity = v.end;
        }
        double mean = 0;
        if (m_line == ContactLine::apart) {
            m_distance -= speed * step;
            if (m_distance <= 0) m_line = m_law.lineAtContact();
        } else {
            if (m_law.isOneWay(m_line) && speed < 0) m_line = ContactLine::elastic;
            const double slope = m_law.slope(m_line);
            if (m_mass > 0) {
                m_force += slope * speed * step;
                mean = (before + m_force) / 2;
            } else {
                const Step f = follow(m_force, 2 * g, slope / m_impedance, step);
                m_force = f.end;
                mean = f.mean;
            }
            if (m_line == ContactLine::elastic && m_force > m_law.largestForce()) {
                // what is above the corner would have grown more slowly
                const double shallow = m_law.slopes().primary / m_law.slopes().elastic;
                m_force = m_law.largestForce() + (m_force - m_law.largestForce()) * shallow;
                m_line = ContactLine::primary;
            }
            if (m_line == ContactLine::primary) {
                while (m_force >= m_law.cornerForce()) {
                    const double corner = m_law.cornerForce(), slopeBefore = m_law.slope(m_line);
                    m_law.passCorner();
                    m_force = corner + (m_force - corner) * m_law.slope(m_line) / slopeBefore;
                }
                m_law.remember(m_force);
            }
            if (m_force <= 0) {
                m_force = 0;
                m_distance = 0;
                m_line = ContactLine::apart;
            }
        }
        m_impulse += mean * step;
        m_peak = std::max(m_peak, m_force);
        return m_mass > 0 ? g - m_impedance * speed : mean - g;
    }
    double work() const { return m_law.worked(m_force); }
    double impulse() const { return m_impulse; }
    double peak() const { return m_peak; }

  private:
    double m_impedance, m_mass;
    ContactLaw<double> m_law;
    ContactLine m_line = ContactLine::apart;
    double m_force = 0, m_velocity = 0, m_distance;
    double m_impulse = 0, m_peak = 0;
};

/// The face of the hammer.
class PlainFace {
  public:
    PlainFace(double z1, double z2, const HammerFace& face)
        : m_z1(z1), m_z2(z2), m_common(z1 * z2 / (z1 + z2)), m_face(face) {}

    /// P, the mean over the step.
    double step(double f1, double b2, double step) {
        if (m_released) return 0;
        const double w = 2 * (f1 / m_z1 + b2 / m_z2);
        if (m_apart) {
            m_gap -= w * step;
            if (m_gap <= 0) m_apart = false;
            return 0;
        }
        double force = m_common * w;
        bool parts = w <= 2e-12;
        if (m_face.stiffness) {
            const Step p = follow(m_force, force, *m_face.stiffness / m_common, step);
            m_force = p.end;
            force = p.mean;
            parts = p.end <= 0;
        }
        if (!parts) return force;
        m_apart = true;
        m_released = !m_face.restrike;
        m_gap = std::max(0.0, -w * step);
        m_force = 0;
        return 0;
    }

  private:
    double m_z1, m_z2, m_common;
    HammerFace m_face;
    bool m_apart = false, m_released = false;
    double m_gap = 0, m_force = 0;
};

}  // namespace

PlainBlow solvePlainLattice(const Problem& problem, const CellGrid& grid, const std::stop_token& stop) {
    assert(problem.endTime);
    const std::vector<UniformSection>& sections = problem.sections;
    const std::size_t last = sections.size() - 1, h = problem.hammerSections();
    std::vector<Ring> rings;
    std::vector<double> velocities(sections.size(), 0), kept, passing;
    const double velocity = problem.isForced() ? 0 : problem.hammer().velocity;
    double stringTime = 0, hammerMass = 0;
    for (std::size_t j = 0; j <= last; ++j) {
        const double transit = static_cast<double>(grid.roundTrips[j]) * grid.cell / 2;
        rings.emplace_back(grid.roundTrips[j], j < h ? -velocity * sections[j].impedance / 2 : 0);
        kept.push_back(std::exp(-sections[j].decay));
        passing.push_back(std::sqrt(1 - sections[j].loss));
        if (j < h)
            velocities[j] = velocity, hammerMass += sections[j].impedance * transit + sections[j].massAfter;
        if (j >= h) stringTime += transit;
    }
    PlainBit bit(problem);
    std::optional<PlainFace> face;
    if (h > 0) face.emplace(sections[h - 1].impedance, sections[h].impedance, problem.hammer().face);
    double energy = hammerMass * velocity * velocity / 2, momentum = hammerMass * velocity;
    PlainBlow blow;
    const long steps = std::lround((*problem.endTime - stringTime) / grid.cell);
    for (long i = 0; i < steps; ++i) {
        if (i % 1024 == 0 && stop.stop_requested()) return blow;
        const double back = kept[0] * rings[0].arriving();
        double f = -back;
        if (problem.isForced()) {
            const double start = static_cast<double>(i) * grid.cell;
            const double impulse =
                problem.force().impulseUntil(start + grid.cell) - problem.force().impulseUntil(start);
            f += impulse / grid.cell;
            energy += impulse * (f - back) / sections[0].impedance;
            momentum += impulse;
        }
        for (std::size_t j = 1; j <= last; ++j) {
            const double z1 = sections[j - 1].impedance, z2 = sections[j].impedance;
            const double f1 = kept[j - 1] * f;
            double b2 = kept[j] * rings[j].arriving(), b1 = 0;
            if (j == h) {
                const double force = face->step(f1, b2, grid.cell);
                b1 = force - f1;
                f = force - b2;
            } else {
                b2 *= passing[j - 1];
                double v = 2 * (f1 - b2) / (z1 + z2);
                if (const double mass = sections[j - 1].massAfter; mass > 0) {
                    const Step moved = follow(velocities[j - 1], v, (z1 + z2) / mass, grid.cell);
                    velocities[j - 1] = moved.end;
                    v = moved.mean;
                }
                b1 = f1 - z1 * v;
                f = passing[j - 1] * (b2 + z2 * v);
            }
            rings[j - 1].leave(b1);
        }
        rings[last].leave(bit.step(kept[last] * f, grid.cell));
    }
    blow.isSolved = true;
    blow.efficiency = bit.work() / energy;
    blow.rockImpulse = bit.impulse() / momentum;
    blow.peakForce = bit.peak();
    blow.cells = std::max(0L, steps) * static_cast<long>(sections.size() + 1);
    return blow;
}

}  // namespace drillwave
