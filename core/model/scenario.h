// SPDX-License-Identifier: GPL-3.0-or-later
// A drilling scenario as plain values: what is described, not how it is solved.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/model/drill_string.h"

namespace drillwave {

// The points of a tabulated pulse: a list that is never changed, so that copies of a scenario share it.

/// Point of a tabulated pulse: time [s] and force [N]; any units in a dimensionless scenario.
struct TablePoint {
    double time = 0;
    double force = 0;
    bool operator==(const TablePoint&) const = default;
};

/// Behaves as a list of points by value; a copy costs a pointer, however many there are.
class TablePoints {
  public:
    TablePoints() = default;
    TablePoints(std::vector<TablePoint> points)
        : m_points(points.empty() ? nullptr
                                  : std::make_shared<const std::vector<TablePoint>>(std::move(points))) {}
    TablePoints(std::initializer_list<TablePoint> points) : TablePoints(std::vector<TablePoint>(points)) {}

    bool empty() const { return !m_points; }
    std::size_t size() const { return list().size(); }
    const TablePoint& operator[](std::size_t i) const { return list()[i]; }
    const TablePoint& front() const { return list().front(); }
    const TablePoint& back() const { return list().back(); }
    auto begin() const { return list().begin(); }
    auto end() const { return list().end(); }

    /// Returns whether both share memory; equal points are not enough.
    bool isSharedWith(const TablePoints& other) const { return m_points == other.m_points; }

    friend bool operator==(const TablePoints& a, const TablePoints& b) {
        return a.isSharedWith(b) || a.list() == b.list();
    }

  private:
    const std::vector<TablePoint>& list() const {
        static const std::vector<TablePoint> none;
        return m_points ? *m_points : none;
    }

    std::shared_ptr<const std::vector<TablePoint>> m_points;  // nullptr where there are none
};

/// Shape of the force of the hammer on the rear end of the rod or of the string (files §1.1).
enum class PulseShape {
    rectangular,  ///< constant over the duration
    triangular,   ///< symmetric rise and fall
    halfSine,     ///< one half period of a sine
    trapezoid,    ///< linear rise, plateau, linear fall
    exponential,  ///< rigid hammer: force ∝ exp(−t/t0), no end
    piston,       ///< uniform elastic hammer: staircase of two impedances, steps of t0
    table,        ///< given points, linear between them
    rigidBody,    ///< reference case: the rod arrives with uniform velocity and no waves
};

/// "half_sine" and so on, as in scenario files.
std::string_view name(PulseShape shape);
std::optional<PulseShape> findPulseShape(std::string_view name);
/// Returns all names, in the order of PulseShape, for menus and messages.
std::span<const std::string_view> pulseShapeNames();

/// Uniform elastic rod. All values in SI.
struct Rod {
    double length = 3.66;                   ///< L [m]
    double diameter = 0.038;                ///< outer diameter [m]; unused when `area` is given
    double bore = 0;                        ///< flushing hole diameter [m]
    std::optional<double> area;             ///< A [m²] when given instead of diameter and bore
    double youngsModulus = 210e9;           ///< E [Pa]
    double density = 7850;                  ///< ρ [kg/m³]
    std::optional<double> yieldStrength;    ///< [Pa] stress above which there is an alert; changes no result
    std::optional<double> fatigueStrength;  ///< [Pa] tension above which there is an alert, for many blows
    bool operator==(const Rod&) const = default;
};

/// Uniform elastic hammer of a `piston` pulse (SI). In a dimensionless scenario only `impedanceRatio` counts.
struct Piston {
    double length = 0.5;                  ///< [m]
    double diameter = 0.038;              ///< [m]
    double velocity = 10;                 ///< impact velocity [m/s]
    std::optional<double> youngsModulus;  ///< [Pa], the rod's when not given
    std::optional<double> density;        ///< [kg/m³], the rod's when not given
    double impedanceRatio = 1;            ///< hammer impedance / rod impedance, dimensionless scenarios
    bool operator==(const Piston&) const = default;
};

/// The hammer blow.
struct Pulse {
    PulseShape shape = PulseShape::rectangular;
    /// t0 [s]; time constant of `exponential`; follows from the data for piston and table
    double duration = 200e-6;
    double impulse = 51;            ///< I0 [N s]; follows from the data for piston and table
    bool impulseFromForce = false;  ///< the user gave the mean force I0/t0, which a file then keeps
    double rise = 0.2;              ///< trapezoid: rise time / duration
    double fall = 0.3;              ///< trapezoid: fall time / duration
    Piston piston;
    std::string tableFile;    ///< path as written in the scenario, empty when the points are inline
    TablePoints tablePoints;  ///< strictly increasing times, forces ≥ 0
    bool operator==(const Pulse&) const = default;
};

/// Kind of the loading curve of the bit–rock law (files §1.4).
enum class RockLaw {
    bilinear,  ///< one straight line
    corners,   ///< straight lines
    power,     ///< F = kU (U/U1)^(p − 1), followed by straight lines
};

/// "bilinear" and so on, as in scenario files.
std::string_view name(RockLaw law);
/// "a power law" and so on, for messages.
std::string_view phrase(RockLaw law);
std::optional<RockLaw> findRockLaw(std::string_view name);
/// Returns all names, in the order of RockLaw.
std::span<const std::string_view> rockLawNames();

/// Corner of the loading curve, from which it has another slope. NaN: not given yet.
struct RockCorner {
    double force = std::numeric_limits<double>::quiet_NaN();  ///< [N], in a dimensionless scenario [F0]
    double slope = std::numeric_limits<double>::quiet_NaN();  ///< from there on, as a multiple of k
    bool operator==(const RockCorner& other) const {
        const auto same = [](double a, double b) { return a == b || (a != a && b != b); };
        return same(force, other.force) && same(slope, other.slope);
    }
};

/// Bit–rock law with memory: the loading curve, and one slope k/γ below the largest force so far.
struct BitRock {
    double stiffness = 105e6;  ///< k, primary loading [N/m]: of the first line, of `power` the secant at U1
    double gamma = 0.1;        ///< elasticity parameter γ, 0 < γ ≤ 1
    double gap = 0;            ///< d, initial gap between bit and rock [m]
    RockLaw law = RockLaw::bilinear;
    std::vector<RockCorner> corners;     ///< of `corners`, forces increasing
    double exponent = 1;                 ///< p of `power`
    double referencePenetration = 1e-3;  ///< U1 of `power` [m], in a dimensionless scenario [d0]
    bool operator==(const BitRock&) const = default;
};

/// State of the rock that the buttons of the bit hit at the next blow.
enum class RockIndexing {
    fresh,  ///< new rock: the bit has turned
    same,   ///< the crater of the blow before
};

/// "fresh" and "same", as in scenario files.
std::string_view name(RockIndexing indexing);
std::optional<RockIndexing> findRockIndexing(std::string_view name);
/// Returns all names, in the order of RockIndexing.
std::span<const std::string_view> rockIndexingNames();

/// Operating data of the rock drill, all optional.
struct Drill {
    std::optional<double> blowFrequency;  ///< [Hz]
    std::optional<double> thrust;         ///< installed feed force [N]
    std::optional<double> machineMass;    ///< carried by the feed besides the rod [kg]
    std::optional<double> inclination;    ///< of the hole below the horizontal [deg], −90 … 90
    // Many blows only
    std::optional<double> damperDamping;    ///< c_d, between machine and rear end [N s/m]
    std::optional<double> damperStiffness;  ///< k_d [N/m]
    RockIndexing indexing = RockIndexing::fresh;
    std::optional<double> waveLoss;         ///< η, of a round trip, 0 ≤ η < 1
    std::optional<double> blows;            ///< N, a whole number
    std::optional<double> settle;           ///< the first of them that no statistic counts, a whole number
    std::optional<double> intervalScatter;  ///< normal deviation of an interval, over 1/f
    std::optional<double> seed;             ///< of that, a whole number
    bool operator==(const Drill&) const = default;
};

/// The four dimensionless groups on which the solution depends (paper, section 5.1) (T8).
struct Groups {
    double beta = 0.5;  ///< β = k/k0, k0 = Z/t0; > 0
    double gamma = 1;   ///< γ, 0 < γ ≤ 1
    double tau = 10;    ///< τ = T/t0; > 0
    double delta = 0;   ///< δ = d/d0, d0 = 2 I0/Z; ≥ 0
    bool operator==(const Groups&) const = default;
};

/// Form in which the scenario is given.
enum class ScenarioForm {
    dimensional,    ///< uniform rod and prescribed hammer force, in physical quantities
    dimensionless,  ///< a uniform rod, directly by its groups
    string,         ///< string of sections under a hammer or a prescribed force, in physical quantities
};

/// Contents of a scenario file. Members that the form does not use keep their defaults.
struct Scenario {
    std::string title;
    ScenarioForm form = ScenarioForm::dimensional;
    Groups groups;            ///< the definition when dimensionless; see groupsOf() otherwise
    Rod rod;                  ///< dimensional only
    Pulse pulse;              ///< where isForced()
    BitRock bitRock;          ///< with units; in a dimensionless scenario the numbers of its loading curve
    Drill drill;              ///< with units
    DrillString drillString;  ///< of a string
    bool operator==(const Scenario&) const = default;
};

/// Whether the scenario is in physical quantities, so that its results have SI units too.
inline bool hasUnits(const Scenario& scenario) {
    return scenario.form != ScenarioForm::dimensionless;
}
/// Whether it is a string of sections, and not a uniform rod.
inline bool isString(const Scenario& scenario) {
    return scenario.form == ScenarioForm::string;
}
/// Whether the blow is a prescribed force, and not a hammer of sections that is followed too.
inline bool isForced(const Scenario& scenario) {
    return !isString(scenario) || scenario.drillString.hammer.sections.empty();
}

}  // namespace drillwave
