// SPDX-License-Identifier: GPL-3.0-or-later
// Tolerances of the sizes and the material of gauge's section and of the sections towards the bit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/study/identify/gauge_place.h"
#include "core/study/identify/identify_question.h"
#include "core/study/identify/record_model.h"

namespace drillwave {

/// A size or material value with its 95 % tolerance.
struct KnownSize {
    std::string key;        ///< "rod.diameter", "string.bit_head.length"
    std::string_view unit;  ///< "m" or "1"
    double value = 0;
    double tolerance = 0;     ///< as the parameter; of moduli and densities relative
    bool isAssumed = true;    ///< not given by --known
    bool isOfGauge = false;   ///< of the section that the gauge is on
    std::size_t section = 0;  ///< of those towards the bit, otherwise
    double impedance = 0;     ///< relative change of Z by the tolerance; 0 of a length
};

/// All of them: diameter, bore, or area of each section, lengths of those towards the bit.
std::vector<KnownSize> knownSizes(const IdentifyQuestion& question, const GaugePlace& place);

/// The same as the model takes them.
SizeTolerances sizeTolerances(const std::vector<KnownSize>& sizes, const GaugePlace& place);

/// Relative 95 % tolerance of k from modulus and density of all sections together.
KnownSize materialTolerance(const IdentifyQuestion& question, const GaugePlace& place);

/// Returns problems of --known: keys that are not of gauge's section or towards the bit, tolerances as large
/// as their values.
std::vector<Message> knownProblems(const IdentifyQuestion& question, const GaugePlace& place);

}  // namespace drillwave
