// SPDX-License-Identifier: GPL-3.0-or-later
// The set-up of a design study as a scenario file keeps it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drillwave {

/// Options of `drillwave design` as texts. A study checks their meaning.
struct DesignSetup {
    std::vector<std::string> uncertain;  ///< "bit_rock.gap=0mm:1mm"
    std::vector<std::string> choose;     ///< "hammer=medium drifter,COP 1838", "rod.length=3m:4m:5"
    std::vector<std::string> aims;       ///< "max:efficiency@q05"
    std::vector<std::string> atMost;     ///< "thrust@q95=8kN"
    std::vector<std::string> atLeast;
    bool keepEnergy = false;
    std::optional<std::uint64_t> samples;
    std::optional<std::uint64_t> seed;

    bool isEmpty() const { return *this == DesignSetup(); }
    bool operator==(const DesignSetup&) const = default;
};

}  // namespace drillwave
