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
    std::string_view unit;  ///< unit of the tolerance: "m", "m^2", or "1" for a relative one
    double value = 0;
    /// 95 % tolerance of the value, in its SI unit; relative for moduli and densities.
    double tolerance = 0;
    bool isAssumed = true;    ///< whether the tolerance is a default because --known does not give it
    bool isOfGauge = false;   ///< whether the value belongs to the section that carries the gauge
    std::size_t section = 0;  ///< index among the sections towards the bit; not used if `isOfGauge`
    /// Relative change of the section's impedance Z if the value, a diameter or area, changes by its
    /// tolerance; 0 for a length.
    double impedance = 0;
};

/// Returns the sizes, with tolerances, of the section with the gauge and of the sections from there to the
/// bit. They are diameter and bore, or the area; for the sections towards the bit also the length.
std::vector<KnownSize> knownSizes(const IdentifyQuestion& question, const GaugePlace& place);

/// Returns the tolerances in the form that RecordModel uses: lengths and relative impedances.
SizeTolerances sizeTolerances(const std::vector<KnownSize>& sizes, const GaugePlace& place);

/// Returns the relative 95 % tolerance of the rock's stiffness k due to the tolerances of Young's modulus and
/// density. These are the ones given for the section with the gauge or for the whole string.
KnownSize materialTolerance(const IdentifyQuestion& question, const GaugePlace& place);

/// Returns the problems of option --known. Its key may be no size of a section from the gauge to the bit. Its
/// tolerance may be as large as the value.
std::vector<Message> knownProblems(const IdentifyQuestion& question, const GaugePlace& place);

}  // namespace drillwave
