// SPDX-License-Identifier: GPL-3.0-or-later
// Bit–rock law of straight lines with memory (paper, Fig. 1; theory §1, §1.1).
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "core/contact/bit_rock_law.h"

namespace drillwave {

/// Unit of penetrations in this law, I0/Z, as a multiple of the unit in results, d0 = 2 I0/Z (T7).
inline constexpr double lawUnitOfPenetration = 0.5;

/// State of the contact: apart, or the line of the bit–rock law on which the force changes.
enum class ContactLine {
    apart,    ///< bit and rock are apart, the force is zero
    primary,  ///< first loading of the rock, with the slope β, or s_j β above corner j of the loading curve
    elastic,  ///< unloading and reloading below the largest force so far, with the slope β/γ
};

/// Bit–rock law with the memory of the rock (T4, T5), dimensionless. Forces F ≥ 0 are in F0, penetrations U
/// (positive into the rock) in I0/Z (half of d0), slopes in F0/(I0/Z) = k0, and work on the rock in
/// I0²/(Z t0).
///
///     U(F) = Σ ΔF_j/(s_j β),   A(F) = Σ Δ(F²)_j/(2 s_j β)    over the lines up to F               (T40)
///     F = max(0, Fm − (β/γ)(Um − U)) below Um = U(Fm), on the loading curve above it              (T41)
///
/// The only memory is the largest force so far, Fm. It remains after separation, so that a second contact
/// begins at the residual penetration Ur. With γ = 1, and while the force has stayed on the first line,
/// loading and unloading coincide, and the memory has no effect. Along any path ∫F dU is worked(F): energy is
/// dissipated only while Fm grows.
template <class Real = double>
class ContactLaw {
  public:
    /// Creates the law of intact rock with one loading line of slope β and an unloading line of slope β/γ.
    /// Requires β > 0 and 0 < γ ≤ 1.
    ContactLaw(Real beta, Real gamma)
        : m_slopes{beta, beta / gamma}, m_beta(beta), m_gamma(gamma), m_isElastic(gamma == 1) {
        assert(beta > 0 && gamma > 0 && gamma <= 1);
    }
    explicit ContactLaw(const BitRockLaw& law) : ContactLaw(law, Real(law.beta)) {}
    /// Creates the law of intact rock with the lines of `law`, but with another stiffness β > 0.
    ContactLaw(const BitRockLaw& law, Real beta) : ContactLaw(beta, Real(law.gamma)) {
        if (!law.isBilinear()) [[unlikely]]
            addLines(law);
    }

    /// Returns the law with every slope limited to `steepest` > 0, in units of k0 = Z/t0. The force of
    /// stiffer rock would change faster than the exact solver can resolve in time. Use only the slopes of the
    /// result: its penetrations do not match β.
    ContactLaw limitedTo(Real steepest) const {
        ContactLaw limited = *this;
        if (m_slopes.elastic <= steepest) return limited;
        limited.m_slopes = {std::min(m_slopes.primary, steepest), std::min(m_slopes.elastic, steepest)};
        limited.m_beta = std::min(m_beta, steepest);
        if (m_lines) {
            LineList list;
            for (const Line& line : *m_lines) list.add(line.force, std::min(line.slope, steepest));
            limited.m_lines = list.share();
        }
        return limited;
    }

    /// Returns the slopes a of the current loading line (β or s_j β) and of the elastic line (β/γ). They are
    /// also the rates of the force, F' = a(2g − F), because the bit moves with U' = 2g − F; g is the incident
    /// wave (T16).
    const ContactRates<Real>& slopes() const { return m_slopes; }
    /// Returns whether loading and unloading coincide, because every loading line that the force has reached
    /// has the slope β/γ.
    bool isElastic() const { return m_isElastic; }

    /// Returns the largest force so far Fm, in units of the mean hammer force F0.
    Real largestForce() const { return m_largest; }
    /// Records that the contact force has risen to `force`, in units of F0. A force above the next corner of
    /// the loading curve is recorded only up to the corner: call passCorner() and then this function again.
    void remember(Real force) {
        if (force > m_largest) m_largest = std::min(force, m_cornerForce);
    }
    /// Records that the contact force has reached `force` [in units of F0], past any corners of the loading
    /// curve.
    void rememberAcross(Real force) {
        while (force >= m_cornerForce) passCorner();
        remember(force);
    }

    // Lines of the law and their corners

    /// Returns the line on which the force rises from zero. It is the `primary` loading line for intact or
    /// elastic rock. Otherwise it is the `elastic` line, which starts at the residual penetration.
    ContactLine lineAtContact() const {
        return isElastic() || m_largest == 0 ? ContactLine::primary : ContactLine::elastic;
    }
    /// Returns whether the force leaves this line of the law as soon as the bit moves back. This holds for
    /// the primary (loading) line, unless loading and unloading coincide (γ = 1).
    bool isOneWay(ContactLine line) const { return line == ContactLine::primary && !isElastic(); }
    /// Returns the slope of the primary or the elastic line, in units of k0 = Z/t0.
    Real slope(ContactLine line) const {
        return line == ContactLine::primary ? m_slopes.primary : m_slopes.elastic;
    }
    /// Returns the index, from 0, of the straight line of the loading curve on which the largest force so far
    /// lies. At a corner, it is the index of the line that starts there.
    std::size_t loadingLine() const { return m_line; }
    /// Returns the slope of the loading line with this index, in units of k0 = Z/t0, whether the force has
    /// reached it or not. Returns 0 if there is no such line.
    Real loadingSlope(std::size_t line) const {
        if (!m_lines) return line == 0 ? m_slopes.primary : Real(0);
        return line < m_lines->size() ? (*m_lines)[line].slope : Real(0);
    }
    bool hasCorner() const { return m_cornerForce < std::numeric_limits<Real>::infinity(); }
    /// Returns the force at which the current loading line ends, in units of F0; infinity if it does not end.
    Real cornerForce() const { return m_cornerForce; }
    /// Moves the largest force so far to the next corner of the loading curve, from which loading continues
    /// on the following line. Requires hasCorner().
    void passCorner() {
        assert(hasCorner());
        m_from = (*m_lines)[++m_line];
        m_slopes.primary = m_from.slope;
        tellLine();
        m_largest = std::max(m_largest, m_from.force);
        findCorner();
    }

    // Force and penetration (T4, T5)

    /// Returns the largest penetration so far Um, in units of I0/Z (hammer impulse over rod impedance).
    Real largestPenetration() const {
        return m_from.penetration + (m_largest - m_from.force) / m_slopes.primary;
    }
    /// Returns the residual penetration Ur = Um − γFm/β, in units of I0/Z. It remains after unloading from
    /// the largest force Fm and penetration Um so far.
    Real residualPenetration() const {
        if (m_isBilinear) [[likely]]
            return (1 - m_gamma) * largestPenetration();
        return largestPenetration() - m_gamma * m_largest / m_beta;
    }
    /// Returns the penetration U, in units of I0/Z, at a force F ≥ 0, in units of F0. Below the largest force
    /// so far it follows the straight unloading line of slope β/γ, above it the loading curve. F = 0 gives
    /// the residual penetration.
    Real penetration(Real force) const {
        if (force >= m_cornerForce) [[unlikely]] {
            ContactLaw loaded = *this;
            loaded.rememberAcross(force);
            return loaded.largestPenetration();
        }
        const Real largest = std::max(m_largest, force);
        if (m_isBilinear) [[likely]]
            return (largest - m_gamma * (largest - force)) / m_beta;
        return m_from.penetration + (largest - m_from.force) / m_slopes.primary -
               m_gamma * (largest - force) / m_beta;
    }
    /// Returns the force F ≥ 0, in units of F0, at a penetration U, in units of I0/Z. Below the largest
    /// penetration so far it follows the straight unloading line of slope β/γ, beyond it the loading curve.
    Real force(Real penetration) const {
        const Real above = largestPenetration() - penetration;
        if (above > 0) return std::max(Real(0), m_largest - m_slopes.elastic * above);
        Line on = m_from;
        on.slope = m_slopes.primary;
        for (std::size_t j = m_line + 1; m_lines && j < m_lines->size(); ++j)
            if (penetration >= (*m_lines)[j].penetration) on = (*m_lines)[j];
        return on.force + on.slope * (penetration - on.penetration);
    }
    /// Returns the change of penetration along the elastic line, in units of I0/Z, for a change of the force,
    /// in units of F0. Both have the same sign.
    Real elasticWay(Real change) const { return change / m_slopes.elastic; }

    // Work on the rock

    /// Returns the energy γF²/(2β) that unloading from a force F ≤ Fm releases, in units of I0²/(Z t0).
    Real givenBack(Real force) const { return force * elasticWay(force) / 2; }
    /// Returns the work A(Fm) of loading the rock up to the largest force so far, in units of I0²/(Z t0)
    /// (T40).
    Real loadingWork() const {
        return m_from.work + (m_largest - m_from.force) * (m_largest + m_from.force) / (2 * m_slopes.primary);
    }
    /// Returns the energy that the rock has absorbed, in units of I0²/(Z t0): A(Fm) − γFm²/(2β). Without
    /// corners this is (1 − γ) Fm²/(2β).
    Real kept() const {
        if (m_isBilinear) [[likely]]
            return m_largest * residualPenetration() / 2;
        return loadingWork() - m_gamma * m_largest * m_largest / (2 * m_beta);
    }
    /// Returns the work ∫F dU done on the rock since the first contact. `force` ≤ Fm is the present force on
    /// the unloading line, in units of F0. The work is in units of I0²/(Z t0).
    Real worked(Real force) const { return kept() + givenBack(force); }

  private:
    /// Line of the loading curve: force, penetration and work of loading at its start, and its slope.
    struct Line {
        Real force = 0, penetration = 0, work = 0;
        Real slope = 0;
    };

    /// List of the straight lines of the loading curve, by increasing force. add() computes penetration and
    /// work at the start of each line; the first line starts at zero.
    struct LineList {
        std::vector<Line> lines;
        void add(Real force, Real slope) {
            assert(slope > 0);
            Line line{.force = force, .slope = slope};
            if (!lines.empty()) {
                const Line& before = lines.back();
                const Real rise = force - before.force;
                // 0 for corners that differ in newtons but round to the same multiple of F0
                assert(rise >= 0);
                line.penetration = before.penetration + rise / before.slope;
                line.work = before.work + rise * (force + before.force) / (2 * before.slope);
            }
            lines.push_back(line);
        }
        std::shared_ptr<const std::vector<Line>> share() {
            return std::make_shared<const std::vector<Line>>(std::move(lines));
        }
    };

    void addLines(const BitRockLaw& law) {
        LineList list;
        list.lines.reserve(law.corners.size() + 1);
        list.add(0, Real(law.firstSlope) * m_beta);
        for (const LawCorner& corner : law.corners) list.add(Real(corner.force), Real(corner.slope) * m_beta);
        m_slopes.primary = list.lines.front().slope;
        m_isElastic = true;
        tellLine();
        m_lines = list.share();
        findCorner();
    }

    /// Updates the flags m_isBilinear and m_isElastic for the loading line now in use.
    void tellLine() {
        m_isBilinear = m_isBilinear && m_slopes.primary == m_beta;
        m_isElastic = m_isElastic && m_slopes.primary == m_slopes.elastic;
    }

    void findCorner() {
        const std::size_t next = m_line + 1;
        m_cornerForce =
            next < m_lines->size() ? (*m_lines)[next].force : std::numeric_limits<Real>::infinity();
    }

    ContactRates<Real> m_slopes;  ///< slopes of the loading line in use and of the elastic line
    Real m_beta;
    Real m_gamma;
    Real m_largest = 0;  ///< largest force so far Fm, in units of F0
    Real m_cornerForce = std::numeric_limits<Real>::infinity();
    std::size_t m_line = 0;    ///< index of the loading line on which the largest force so far is
    Line m_from;               ///< start of that loading line
    bool m_isBilinear = true;  ///< whether every loading line that the force has reached has the slope β
    /// Whether loading and unloading coincide, so that no energy is absorbed. This holds if every loading
    /// line that the force has reached has the slope β/γ of the elastic line.
    bool m_isElastic;
    std::shared_ptr<const std::vector<Line>> m_lines;  ///< loading lines; nullptr for a law without corners
};

}  // namespace drillwave
