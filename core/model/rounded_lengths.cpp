// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/rounded_lengths.h"

#include <algorithm>
#include <cmath>

namespace drillwave {
namespace {

void roundLength(Section& section) {
    const double length = roundedLength(section.length);
    if (length == section.length) return;
    section.length = length;
    section.preset.clear();
}

}  // namespace

double roundedLength(double length) {
    const double millimetres = length * 1000;
    const double step = millimetres >= 50 ? 10 : millimetres >= 20 ? 5 : 1;
    const double rounded = std::max(1.0, std::round(millimetres / step)) * step / 1000;
    return std::abs(rounded - length) <= 1e-12 * length ? length : rounded;
}

DrillString withRoundedLengths(DrillString drillString) {
    for (Section& section : drillString.hammer.sections) roundLength(section);
    for (StringPart& part : drillString.parts)
        for (Section& section : part.sections) roundLength(section);
    return drillString;
}

}  // namespace drillwave
