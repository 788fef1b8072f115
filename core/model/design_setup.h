// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of a design study as a scenario file stores them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drillwave {

/// Options of the command `drillwave design`, as the texts that the user enters. The study checks them when
/// it starts.
struct DesignSetup {
    std::vector<std::string> uncertain;  ///< inputs with their range of uncertainty, "bit_rock.gap=0mm:1mm"
    /// Design variables, each with the values to be compared: "hammer=medium drifter,COP 1838",
    /// "rod.length=3m:4m:5".
    std::vector<std::string> choose;
    std::vector<std::string> aims;    ///< objectives, "max:efficiency@q05"
    std::vector<std::string> atMost;  ///< upper limits on results, "thrust@q95=8kN"
    std::vector<std::string> atLeast;
    bool keepEnergy = false;
    std::optional<std::uint64_t> samples;
    std::optional<std::uint64_t> seed;

    bool isEmpty() const { return *this == DesignSetup(); }
    bool operator==(const DesignSetup&) const = default;
};

}  // namespace drillwave
