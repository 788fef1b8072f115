// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/step_law.h"

#include <cassert>

namespace drillwave {

namespace {

/// The positive root of A x² + b x + c = 0 for A > 0, c ≤ 0, without cancellation.
double positiveRoot(double A, double b, double c) {
    const double root = std::sqrt(b * b - 4 * A * c);
    return b > 0 ? -2 * c / (b + root) : (root - b) / (2 * A);
}

/// q of (T33) on a line of that slope.
double weight(double rate, double step) {
    return rate * step / 2 / (1 + rate * step / 2);
}

/// The way of the front end into the rock during one step: how far it can go along one line of the law after
/// the other until the velocity that the force leaves it is used up.
class Way {
  public:
    Way(double g, double step, double force) : m_g(g), m_step(step), m_force(force) {}

    /// Whether the front end gets beyond a line of that length and slope. If not, it ends on it.
    bool passes(double length, double slope) {
        const double end = m_advance + length;
        const double work = m_work + (m_force + slope * length / 2) * length;
        if ((2 * m_g - end / m_step) * end < work) {
            follow(slope);
            return false;
        }
        m_advance = end;
        m_work = work;
        m_force += slope * length;
        return true;
    }

    /// Ends on a line of that slope: (2g − dU/Δ) dU = work, for the way x along the line.
    void follow(double slope) {
        const double x = positiveRoot(1 / m_step + slope / 2, m_force - 2 * m_g + 2 * m_advance / m_step,
                                      std::fmin(0, m_work - (2 * m_g - m_advance / m_step) * m_advance));
        m_work += (m_force + slope * x / 2) * x;
        m_advance += x;
        m_force += slope * x;
    }

    double advance() const { return m_advance; }
    double meanForce() const { return m_advance > 0 ? m_work / m_advance : m_force; }
    double endForce() const { return m_force; }

  private:
    double m_g, m_step;
    double m_advance = 0, m_work = 0, m_force;
};

}  // namespace

StepLaw::StepLaw(const ContactLaw<>& law, double step, double gap, double negligible)
    : m_law(law),
      m_step(step),
      m_loading(weight(law.slopes().primary, step)),
      m_unloading(weight(law.slopes().elastic, step)),
      m_negligible(negligible),
      m_gap(gap) {
    assert(step > 0 && gap >= 0 && negligible >= 0);
}

/// Across the gap, up to the largest force so far, and on along the loading curve.
double StepLaw::load(double g) {
    Way way(g, m_step, m_force);
    bool onTheWay = true;
    double contactAt = 0, primaryAt = 0;
    if (!m_touches) {
        m_changes |= contact;
        onTheWay = way.passes(m_gap, 0);
        contactAt = way.advance();
        m_touches = true;
        m_gap = 0;
    }
    if (onTheWay && !m_law.isElastic() && m_force < peak()) {
        onTheWay = way.passes(m_law.elasticWay(peak() - m_force), m_law.slopes().elastic);
        if (onTheWay) m_changes |= primaryLoading;
        primaryAt = way.advance();
    }
    while (onTheWay && m_law.hasCorner()) {
        const double slope = m_law.slopes().primary;
        onTheWay = way.passes((m_law.cornerForce() - way.endForce()) / slope, slope);
        if (onTheWay) passCorner(way.advance());
    }
    if (onTheWay) way.follow(m_law.slopes().primary);
    const auto shareOfWay = [&](double at) { return way.advance() > 0 ? at / way.advance() : 1; };
    m_contactFraction = shareOfWay(contactAt);
    m_primaryFraction = shareOfWay(primaryAt);
    if (m_changes & corner)
        for (double& at : m_cornerFractions) at = shareOfWay(at);
    m_force = way.endForce();
    m_law.remember(m_force);
    return way.meanForce();
}

/// The end of a line is reached after that way.
void StepLaw::passCorner(double advance) {
    if (!(m_changes & corner)) m_cornerFractions.clear();
    m_changes |= corner;
    m_cornerFractions.push_back(advance);
    m_law.passCorner();
    m_loading = weight(m_law.slopes().primary, m_step);
}

/// Down the unloading line, whose work w = f²/(2a) is given back, and away: (2g + y/Δ) y = w, y = −dU.
double StepLaw::separate(double g) {
    m_changes |= separation;
    const double toZero = m_law.elasticWay(m_force);
    const double work = m_law.givenBack(m_force);
    const double away = positiveRoot(1 / m_step, 2 * g, -work);
    m_separationFraction = away > 0 ? std::fmin(1, toZero / away) : 0;
    m_touches = false;
    m_gap = std::fmax(0, away - toZero);
    m_force = 0;
    return away > 0 ? work / away : 0.0;
}

}  // namespace drillwave
