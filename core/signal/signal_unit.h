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
    force,     ///< force [N]
    strain,    ///< strain [m/m]
    bridge,    ///< output of a Wheatstone bridge relative to its supply [V/V]
    voltage,   ///< output of an amplifier or bridge [V]; gain and excitation convert it to V/V
    stress,    ///< stress [Pa]
    velocity,  ///< particle velocity [m/s]; the impedance of the bar converts it to a force
};

/// Unit of a signal. `factor` is the value of one unit in N, m/m, V/V, V, Pa or m/s, depending on the kind of
/// signal.
struct SignalUnit {
    std::string_view name;  ///< name, "kN", "microstrain", "mV/V"
    double factor = 1;
    bool operator==(const SignalUnit&) const = default;
};

/// Returns the units of one kind of signal, the most common first.
std::vector<SignalUnit> signalUnits(SignalKind kind);

/// Unit of a signal together with the kind of signal that it belongs to.
struct NamedSignalUnit {
    SignalKind kind = SignalKind::force;
    SignalUnit unit;
    bool operator==(const NamedSignalUnit&) const = default;
};
/// Returns the unit with this name, of any kind of signal, or nullopt. Names are case-sensitive.
std::optional<NamedSignalUnit> findSignalUnit(std::string_view name);

/// Returns the length in seconds of the unit of time with this name: 1e-6 for "us", "µsec" or
/// "Mikrosekunden". Returns nullopt for any other word.
std::optional<double> findTimeUnit(std::string_view name);

/// Returns the unit of sampling rate that a word stands for, in Hz: "MHz", "kS/s", "samples/s"; nullopt for
/// any other word.
std::optional<double> findRateUnit(std::string_view name);

/// Returns a sampling rate [Hz] as text with a suitable unit: "5 MHz".
std::string rateText(double rate);

/// Bar with strain gauges, and the bridge that measures its strain. The normal force is N = E A ε with the
/// strain ε = 4 r/(k·n) and the bridge output r = U/(g·V). Here k is the gauge factor, n the bridge factor,
/// U the amplified voltage, g the gain and V the supply.
struct GaugedBar {
    double axialStiffness = 0;  ///< axial stiffness E A [N], > 0
    double gaugeFactor = 2;     ///< gauge factor k > 0 of the strain gauges; for signals in V/V and V
    /// Bridge factor n: 1 quarter, 2 half, 4 full bridge with gauges at ±ε, 2.6 full with Poisson gauges
    /// (ν = 0.3).
    double activeGauges = 1;
    double gain = 1;          ///< gain g > 0 of the amplifier; for signals in V
    double excitation = 1;    ///< supply V > 0 of the bridge [V]; for signals in V
    double area = 0;          ///< cross-section A [m²], > 0; for stresses
    double forcePerVolt = 0;  ///< calibration factor [N/V], used instead of the bridge data; 0 for none
    double impedance = 0;     ///< characteristic impedance Z = E A/c [N s/m], > 0; for velocities
    bool operator==(const GaugedBar&) const = default;
};

/// Returns the normal force [N] that corresponds to the number 1 in the file. `unitFactor` is the value of
/// the file's unit in N, m/m, V/V, V, Pa or m/s, depending on `kind`.
double forcePerNumber(SignalKind kind, double unitFactor, const GaugedBar& bar);

// Headings of columns of samples.

/// Column of a table; name and unit are empty if no header gives them.
struct TableColumn {
    std::string name;
    std::string unit;
    bool isNumeric = false;  ///< whether most of the column's first cells are numbers
    /// Whether most of the column's first cells are times of day, with or without a date.
    bool isStamp = false;
    bool isIndex = false;  ///< whether the numbers in the column's first cells increase by one per row
    bool operator==(const TableColumn&) const = default;
};

/// Returns the name and unit in the heading of a table column, such as "time [us]", "Time (us)", "t / us",
/// "t/us", "t in us", "t us", "t, us" or "time_us". In "F [kN] filtered" the unit is in the last brackets
/// with a known unit. Text in brackets at the end, after " / " or after " in " is a unit even if unknown. In
/// the other forms only a known unit counts as a unit.
TableColumn columnOf(std::string_view heading);

/// Returns whether a word is a known unit of time or of a signal.
bool isKnownUnit(std::string_view word);

/// Returns whether the name of a column stands for time: "t", "Time", "Zeit".
bool isTimeName(std::string_view name);

}  // namespace drillwave
