// SPDX-License-Identifier: GPL-3.0-or-later
// The law of bit and rock: straight lines, with memory (paper, Fig. 1; theory §1, §1.1).
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "core/contact/bit_rock_law.h"

namespace drillwave {

/// Unit of penetrations in the law, I0/Z, in units of results, d0 = 2 I0/Z (T7).
inline constexpr double lawUnitOfPenetration = 0.5;

/// State of the force, between two corners of the law.
enum class ContactLine {
    apart,    ///< no force
    primary,  ///< first loading, of slope β, or s_j β after a corner
    elastic,  ///< below the largest force so far, of slope β/γ, up and down
};

/// Law with the memory of the rock (T4) (T5), dimensionless: forces F ≥ 0 in F0, penetrations U into the rock
/// positive in I0/Z (half of d0), slopes in F0/(I0/Z) = k0, work on the rock in I0²/(Z t0).
///
///     U(F) = Σ ΔF_j/(s_j β),   A(F) = Σ Δ(F²)_j/(2 s_j β)    over the lines up to F               (T40)
///     F = max(0, Fm − (β/γ)(Um − U)) below Um = U(Fm), on the loading curve above it              (T41)
///
/// The largest force so far, Fm, is the whole memory. It survives separation, so that a second contact begins
/// at the residual penetration Ur. With γ = 1, and while the force has stayed on the first line, both lines
/// are one and the memory has no effect. Along any path ∫F dU is worked(F): the law dissipates only where Fm
/// grows.
template <class Real = double>
class ContactLaw {
  public:
    /// Untouched rock without corners: β > 0 and 0 < γ ≤ 1.
    ContactLaw(Real beta, Real gamma)
        : m_slopes{beta, beta / gamma}, m_beta(beta), m_gamma(gamma), m_isElastic(gamma == 1) {
        assert(beta > 0 && gamma > 0 && gamma <= 1);
    }
    explicit ContactLaw(const BitRockLaw& law) : ContactLaw(law, Real(law.beta)) {}
    /// Takes another β.
    ContactLaw(const BitRockLaw& law, Real beta) : ContactLaw(beta, Real(law.gamma)) {
        if (!law.isBilinear()) [[unlikely]]
            addLines(law);
    }

    /// Returns the law with no line steeper than `steepest`. For the rates of a solver: penetrations are no
    /// longer those of β.
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

    /// Returns β, or s_j β after a corner, and β/γ. As U' = 2g − F, these are rates of F' = a(2g − F) (T16).
    const ContactRates<Real>& slopes() const { return m_slopes; }
    /// Returns whether it has no memory: as long as the loading lines have been as steep as the elastic one.
    bool isElastic() const { return m_isElastic; }

    Real largestForce() const { return m_largest; }  ///< Fm
    /// The force has been as large as that, up to the next corner: beyond it passCorner() leads.
    void remember(Real force) {
        if (force > m_largest) m_largest = std::min(force, m_cornerForce);
    }
    /// Remembers that the force has been that large, across any corners.
    void rememberAcross(Real force) {
        while (force >= m_cornerForce) passCorner();
        remember(force);
    }

    // The lines and their corners

    /// Returns the line on which the force rises from zero: the primary one in untouched or elastic rock,
    /// else the elastic one, from the bottom of the crater.
    ContactLine lineAtContact() const {
        return isElastic() || m_largest == 0 ? ContactLine::primary : ContactLine::elastic;
    }
    /// Returns whether that line is left as soon as the bit turns back: the primary one, except for γ = 1.
    bool isOneWay(ContactLine line) const { return line == ContactLine::primary && !isElastic(); }
    /// Returns the slope of a line in contact.
    Real slope(ContactLine line) const {
        return line == ContactLine::primary ? m_slopes.primary : m_slopes.elastic;
    }
    /// Returns the loading line of the largest force, from 0; at a corner the one after it.
    std::size_t loadingLine() const { return m_line; }
    /// Returns the slope of any loading line, in use or not; 0 if there is no such line.
    Real loadingSlope(std::size_t line) const {
        if (!m_lines) return line == 0 ? m_slopes.primary : Real(0);
        return line < m_lines->size() ? (*m_lines)[line].slope : Real(0);
    }
    bool hasCorner() const { return m_cornerForce < std::numeric_limits<Real>::infinity(); }
    /// Returns the force at which that line ends; infinite if it never ends.
    Real cornerForce() const { return m_cornerForce; }
    /// Continues the loading after the next corner, which must exist.
    void passCorner() {
        assert(hasCorner());
        m_from = (*m_lines)[++m_line];
        m_slopes.primary = m_from.slope;
        tellLine();
        m_largest = std::max(m_largest, m_from.force);
        findCorner();
    }

    // Force and penetration (T4) (T5)

    /// Um.
    Real largestPenetration() const {
        return m_from.penetration + (m_largest - m_from.force) / m_slopes.primary;
    }
    /// Returns Ur = Um − γFm/β, the penetration left at zero force.
    Real residualPenetration() const {
        if (m_isBilinear) [[likely]]
            return (1 - m_gamma) * largestPenetration();
        return largestPenetration() - m_gamma * m_largest / m_beta;
    }
    /// U at a force 0 ≤ F: on the elastic line up to Fm, beyond it on the loading curve. Without force: Ur.
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
    /// F at any penetration.
    Real force(Real penetration) const {
        const Real above = largestPenetration() - penetration;
        if (above > 0) return std::max(Real(0), m_largest - m_slopes.elastic * above);
        Line on = m_from;
        on.slope = m_slopes.primary;
        for (std::size_t j = m_line + 1; m_lines && j < m_lines->size(); ++j)
            if (penetration >= (*m_lines)[j].penetration) on = (*m_lines)[j];
        return on.force + on.slope * (penetration - on.penetration);
    }
    /// Returns the penetration along the elastic line over which the force changes by as much.
    Real elasticWay(Real change) const { return change / m_slopes.elastic; }

    // Work on the rock

    /// Returns the energy released by unloading from a force F ≤ Fm: γF²/(2β).
    Real givenBack(Real force) const { return force * elasticWay(force) / 2; }
    /// Returns the work on the rock up to the largest force: A(Fm) (T40).
    Real loadingWork() const {
        return m_from.work + (m_largest - m_from.force) * (m_largest + m_from.force) / (2 * m_slopes.primary);
    }
    /// Returns the energy left in the rock: A(Fm) − γFm²/(2β), (1 − γ) Fm²/(2β) without corners.
    Real kept() const {
        if (m_isBilinear) [[likely]]
            return m_largest * residualPenetration() / 2;
        return loadingWork() - m_gamma * m_largest * m_largest / (2 * m_beta);
    }
    /// Returns ∫F dU from the first touch until the force is F ≤ Fm.
    Real worked(Real force) const { return kept() + givenBack(force); }

  private:
    /// A loading line: where it begins, and how steep it is.
    struct Line {
        Real force = 0, penetration = 0, work = 0;
        Real slope = 0;
    };

    /// The loading lines, from the one that begins at zero.
    struct LineList {
        std::vector<Line> lines;
        void add(Real force, Real slope) {
            assert(slope > 0);
            Line line{.force = force, .slope = slope};
            if (!lines.empty()) {
                const Line& before = lines.back();
                const Real rise = force - before.force;
                assert(rise >= 0);  // 0 where corners differ in newtons, and not as multiples of F0
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

    /// Updates the flags that describe the law for the line now in use.
    void tellLine() {
        m_isBilinear = m_isBilinear && m_slopes.primary == m_beta;
        m_isElastic = m_isElastic && m_slopes.primary == m_slopes.elastic;
    }

    void findCorner() {
        const std::size_t next = m_line + 1;
        m_cornerForce =
            next < m_lines->size() ? (*m_lines)[next].force : std::numeric_limits<Real>::infinity();
    }

    ContactRates<Real> m_slopes;  ///< of the loading line in use, and of the elastic one
    Real m_beta;
    Real m_gamma;
    Real m_largest = 0;  ///< Fm
    Real m_cornerForce = std::numeric_limits<Real>::infinity();
    std::size_t m_line = 0;                            ///< loading line of Fm
    Line m_from;                                       ///< where it begins
    bool m_isBilinear = true;                          ///< still on the line of slope β from zero
    bool m_isElastic;                                  ///< all so far were as steep as the elastic one
    std::shared_ptr<const std::vector<Line>> m_lines;  ///< where there are corners
};

}  // namespace drillwave
