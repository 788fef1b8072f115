// SPDX-License-Identifier: GPL-3.0-or-later
// Units of recorded signals: a force, a strain, or the output of a bridge of strain gauges.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

enum class SignalKind {
    force,     ///< in N
    strain,    ///< in m/m
    bridge,    ///< output over supply of a Wheatstone bridge, V/V
    voltage,   ///< output of an amplifier or a bridge in V: gain and excitation make V/V of it
    stress,    ///< in Pa
    velocity,  ///< of a particle, in m/s: the impedance of the bar makes a force of it
};

/// Value of the number 1 in a file, in N, m/m, V/V, V, Pa or m/s.
struct SignalUnit {
    std::string_view name;  ///< "kN", "microstrain", "mV/V"
    double factor = 1;
    bool operator==(const SignalUnit&) const = default;
};

/// The units of a kind, the commonest first.
std::vector<SignalUnit> signalUnits(SignalKind kind);

/// The unit of that name of whatever kind; case counts.
struct NamedSignalUnit {
    SignalKind kind = SignalKind::force;
    SignalUnit unit;
    bool operator==(const NamedSignalUnit&) const = default;
};
std::optional<NamedSignalUnit> findSignalUnit(std::string_view name);

/// The unit of time that a word is, "us", "µsec", "Mikrosekunden", in s.
std::optional<double> findTimeUnit(std::string_view name);

/// The sampling rates that a text can be in, "MHz", "kS/s", "samples/s", in Hz.
std::optional<double> findRateUnit(std::string_view name);

/// A sampling rate [Hz] for people: "5 MHz".
std::string rateText(double rate);

/// Where strain gauges sit, and how a bridge tells their strain: N = E A ε, ε = 4 r/(k n), r = U/(g V).
struct GaugedBar {
    double axialStiffness = 0;  ///< E A [N], > 0
    double gaugeFactor = 2;     ///< k > 0, of the gauges; for bridges and volts
    double activeGauges = 1;  ///< n: 1 quarter bridge, 2, 4 full bridge that see ±ε, 2.6 full with ν = 0.3
    double gain = 1;          ///< g > 0 of the amplifier; for volts
    double excitation = 1;    ///< V > 0 of the bridge [V]; for volts
    double area = 0;          ///< A [m²], > 0; for stresses
    double forcePerVolt = 0;  ///< of a calibration [N/V], which goes before the bridge; 0 for none
    double impedance = 0;     ///< Z = E A/c [N s/m], > 0; for velocities
    bool operator==(const GaugedBar&) const = default;
};

/// Returns the normal force [N] for the number 1 in the file.
double forcePerNumber(SignalKind kind, double unitFactor, const GaugedBar& bar);

// Headings of columns of samples.

/// One column; name and unit are empty if no header gives them.
struct TableColumn {
    std::string name;
    std::string unit;
    bool isNumeric = false;  ///< most of its first cells are numbers
    bool isStamp = false;    ///< most of its first cells are times of day or dates with one
    bool isIndex = false;    ///< its first cells count on by one
    bool operator==(const TableColumn&) const = default;
};

/// Splits "time [us]", "Time (us)", "t / us", "t/us", "t in us", "t us", "t, us", "time_us" into their parts,
/// and "F [kN] filtered", where the last brackets with a known unit are inside. A text in brackets at the
/// end, after " / " or after " in " is a unit, known or not; the others require a known unit.
TableColumn columnOf(std::string_view heading);

/// Returns whether a word is a unit of time or of a signal.
bool isKnownUnit(std::string_view word);

/// Whether a column of this name holds times: "t", "Time", "Zeit".
bool isTimeName(std::string_view name);

}  // namespace drillwave
