// SPDX-License-Identifier: GPL-3.0-or-later
// The law of bit and rock: bilinear, with memory (paper, Fig. 1; theory §1).
#pragma once

#include <algorithm>
#include <cassert>

#include "core/contact/bit_rock_law.h"
#include "core/contact/contact_rates.h"

namespace drillwave {

/// I0/Z, the unit of penetrations in the law, in d0 = 2 I0/Z, that of results (T7).
inline constexpr double lawUnitOfPenetration = 0.5;

/// What the force is on, between two corners of the law.
enum class ContactLine {
    apart,    ///< no force
    primary,  ///< first loading, of slope β
    elastic,  ///< below the largest force so far, of slope β/γ, up and down
};

/// The bilinear law and what the rock remembers (T4) (T5), dimensionless: forces F ≥ 0 in F0, penetrations U
/// into the rock positive in I0/Z (half of d0), slopes in F0/(I0/Z) = k0, work on the rock in I0²/(Z t0).
///
///     F = max(0, β Um − (β/γ)(Um − U)),   Um = Fm/β
///
/// The largest force so far, Fm, is the whole memory. It survives separation, so that a second contact begins
/// at the residual penetration Ur. With γ = 1 the two lines are one, and nothing that is remembered matters.
/// Along any path ∫F dU is worked(F): the law dissipates only where Fm grows.
template <class Real = double>
class BilinearLaw {
  public:
    /// Untouched rock: β > 0 and 0 < γ ≤ 1.
    BilinearLaw(Real beta, Real gamma) : m_slopes{beta, beta / gamma}, m_gamma(gamma) {
        assert(beta > 0 && gamma > 0 && gamma <= 1);
    }
    explicit BilinearLaw(const BitRockLaw& law) : BilinearLaw(Real(law.beta), Real(law.gamma)) {}

    /// The same lines, none steeper than `steepest`. For the rates of a solver: penetrations are no longer
    /// those of β.
    BilinearLaw limitedTo(Real steepest) const {
        BilinearLaw limited = *this;
        limited.m_slopes = {std::min(m_slopes.primary, steepest), std::min(m_slopes.elastic, steepest)};
        return limited;
    }

    /// β and β/γ. As U' = 2g − F they are the rates of F' = a(2g − F) (T16).
    const ContactRates<Real>& slopes() const { return m_slopes; }
    bool isElastic() const { return m_gamma == 1; }  ///< one line, no memory

    Real largestForce() const { return m_largest; }  ///< Fm
    /// The force has been as large as that.
    void remember(Real force) {
        if (force > m_largest) m_largest = force;
    }

    // The lines and their corners

    /// Where the force rises from zero: on the primary line in untouched rock, else from the bottom of the
    /// crater.
    ContactLine lineAtContact() const {
        return isElastic() || m_largest == 0 ? ContactLine::primary : ContactLine::elastic;
    }
    /// Whether that line is left as soon as the bit turns back: the primary one, but for γ = 1.
    bool isOneWay(ContactLine line) const { return line == ContactLine::primary && !isElastic(); }
    /// The slope of a line in contact.
    Real slope(ContactLine line) const {
        return line == ContactLine::primary ? m_slopes.primary : m_slopes.elastic;
    }

    // Force and penetration (T4) (T5)

    /// Um.
    Real largestPenetration() const { return m_largest / m_slopes.primary; }
    /// Ur = (1 − γ) Um, what stays when the force is gone.
    Real residualPenetration() const { return (1 - m_gamma) * largestPenetration(); }
    /// U at a force 0 ≤ F: on the elastic line up to Fm, beyond it on the primary one. Without force: Ur.
    Real penetration(Real force) const {
        const Real largest = std::max(m_largest, force);
        return (largest - m_gamma * (largest - force)) / m_slopes.primary;
    }
    /// F at any penetration.
    Real force(Real penetration) const {
        const Real above = largestPenetration() - penetration;
        if (above <= 0) return m_slopes.primary * penetration;
        return std::max(Real(0), m_largest - m_slopes.elastic * above);
    }
    /// The way along the elastic line over which the force changes by as much.
    Real elasticWay(Real change) const { return change / m_slopes.elastic; }

    // Work on the rock

    /// What unloading from a force F ≤ Fm gives back: γF²/(2β).
    Real givenBack(Real force) const { return force * elasticWay(force) / 2; }
    /// What stays in the rock: (1 − γ) Fm²/(2β).
    Real kept() const { return m_largest * residualPenetration() / 2; }
    /// ∫F dU of all that has happened, when the force is F ≤ Fm.
    Real worked(Real force) const { return kept() + givenBack(force); }

  private:
    ContactRates<Real> m_slopes;
    Real m_gamma;
    Real m_largest = 0;  ///< Fm
};

}  // namespace drillwave
