// SPDX-License-Identifier: GPL-3.0-or-later
// Force on the rock for a trial law, under an incident wave that is linear within each time step. All values
// are in SI units.
#pragma once

#include <cstddef>
#include <vector>

namespace drillwave {

/// Straight line of a rock's loading curve: while the force is above `force`, it rises with penetration by
/// `slope`.
struct TrialLine {
    double force = 0;  ///< force at which the line starts [N], 0 for the first line
    double slope = 1;  ///< stiffness on this line [N/m], > 0
};

/// Rock law with the values that a fit tries (theory, eqs. T4, T5 and T40). The last line of the loading
/// curve has no upper end.
struct TrialRock {
    std::vector<TrialLine> lines = {{}};  ///< lines of the loading curve, with increasing forces
    double elastic = 1;  ///< stiffness of unloading and reloading below the largest force so far, k/γ [N/m]
    double gap = 0;      ///< gap d between bit and rock, ≥ 0 [m]
    double dashpot = 0;  ///< constant c ≥ 0 of a dashpot beside the spring, active in contact [N s/m]
};

/// Returns straight lines (chords) that approximate the power law F = kU (U/U1)^(p − 1) of force F over
/// penetration U. At U1 the force is `reference` [N]; k = F/U there is `stiffness` [N/m]. p is `exponent`.
std::vector<TrialLine> powerLines(double stiffness, double exponent, double reference);

/// Time-stepping solver for the penetration U of a bit and the force F on the rock. The bit is at the end of
/// a section of impedance Z, under an incident wave g. The equation is U' = (2g − F)/Z (theory, eq. T16). On
/// a specimen in front of a bar of the same impedance it is U' = (2g − 2F)/Z. With a bit mass M it is M U'' +
/// Z U' + F = 2g.
/// Within a time step g is linear. Without a bit mass, each straight line of the rock law is solved exactly,
/// and its corners are located within the step. With a bit mass the trapezoidal rule is used.
class RockResponse {
  public:
    struct End {
        double impedance = 1;  ///< impedance Z of the last section [N s/m]
        double mass = 0;       ///< mass M of the bit [kg]
        bool barBehind = false;
    };
    RockResponse(const TrialRock& rock, const End& end, double step);

    /// Advances the solution by one step, in which the incident wave g changes from `g0` to `g1` [N].
    void advance(double g0, double g1);

    /// Returns the force on the rock F ≥ 0 at the end of the step [N].
    double force() const { return m_force; }
    /// Returns the wave b reflected by the rock [N] if the incident wave there is `g` [N].
    double reflected(double g) const { return m_mass > 0 ? g - m_impedance * m_velocity : m_force - g; }
    /// Returns the position of the bit relative to the untouched rock [m]: positive in the rock, negative
    /// within the gap.
    double penetration() const;
    bool hasUnloaded(double share) const { return m_spring < (1 - share) * m_largest; }

  private:
    enum class Line { apart, primary, elastic };
    struct Wave {
        /// Driving force of the equation of motion: 2g [N], or g for a specimen in front of a bar. `rate` is
        /// its rate of change [N/s].
        double g, rate;
    };
    double rateOf(double slope) const { return slope / (m_impedance + m_dashpot); }
    double springAfter(const Wave& wave, double rate, double time) const;
    double timeTo(const Wave& wave, double rate, double end, double force) const;
    bool follow(Wave& wave, double& left);
    void load(const Wave& wave, double& left);
    void unload(const Wave& wave, double& left);
    void fly(const Wave& wave, double& left);
    void advanceMass(double g0, double g1);
    void touch();
    void separate();
    double largestPenetration() const;

    const TrialRock& m_rock;
    double m_impedance;  ///< impedance Z [N s/m]; half of it for a specimen in front of a bar
    double m_double;     ///< factor of g in the equation of motion: 2, or 1 for a specimen in front of a bar
    double m_mass;
    double m_dashpot;
    double m_step;
    Line m_line = Line::apart;
    std::size_t m_loading = 0;  ///< index of the current line of the loading curve
    /// Penetration at the lower end of the current line of the loading curve [m].
    double m_loadedPenetration = 0;
    double m_spring = 0;    ///< force of the spring, without the dashpot [N]
    double m_largest = 0;   ///< Fm, largest force of the spring so far [N]
    double m_place = 0;     ///< position of the bit while it is not in contact [m]
    double m_contact = 0;   ///< position of the rock's surface [m]
    double m_velocity = 0;  ///< velocity of the bit mass [m/s]
    double m_force = 0;
};

}  // namespace drillwave
