// SPDX-License-Identifier: GPL-3.0-or-later
// Tolerances of the sizes and materials of the gauge's section and of the sections towards the bit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/study/identify/gauge_place.h"
#include "core/study/identify/identify_question.h"
#include "core/study/identify/record_model.h"

namespace drillwave {

/// Size or material property of a section, with its 95 % tolerance.
struct KnownSize {
    std::string key;        ///< key of the value, such as "rod.diameter" or "string.bit_head.length"
    std::string_view unit;  ///< unit of the tolerance: "m", or "1" for a relative one
    double value = 0;
    /// 95 % tolerance in the SI unit of the parameter; relative for moduli and densities.
    double tolerance = 0;
    bool isAssumed = true;    ///< whether the tolerance is a default because --known does not give it
    bool isOfGauge = false;   ///< whether the value belongs to the section that carries the gauge
    std::size_t section = 0;  ///< index among the sections towards the bit; not used if `isOfGauge`
    /// Relative change of the impedance Z if the value changes by its tolerance; 0 for a length.
    double impedance = 0;
};

/// Returns all sizes with tolerances: diameter and bore, or area, of each section; lengths of the sections
/// towards the bit.
std::vector<KnownSize> knownSizes(const IdentifyQuestion& question, const GaugePlace& place);

/// Returns the tolerances in the form used by the record model, as lengths and relative impedances.
SizeTolerances sizeTolerances(const std::vector<KnownSize>& sizes, const GaugePlace& place);

/// Returns the relative 95 % tolerance of the stiffness k that the moduli and densities of all sections cause
/// together.
KnownSize materialTolerance(const IdentifyQuestion& question, const GaugePlace& place);

/// Returns the problems of option --known. They are keys that belong to neither the gauge's section nor a
/// section towards the bit, and tolerances as large as their values.
std::vector<Message> knownProblems(const IdentifyQuestion& question, const GaugePlace& place);

}  // namespace drillwave
