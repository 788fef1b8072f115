#include "core/study/result_alerts.h"

#include <array>
#include <charconv>

#include "core/study/thrust.h"

namespace drillwave {

namespace {

/// The largest error of e that an engineer need not be told about: what the solver promises in its whole
/// domain.
constexpr double promisedError = 1e-9;

std::string rounded(double value) {
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4);
    return {text.data(), end.ptr};
}

}  // namespace

std::vector<Alert> resultAlerts(const Scenario& scenario, const ImpactSummary& summary) {
    std::vector<Alert> alerts;
    const std::optional<double> needed = thrustNeeded(scenario, summary.cor);
    const std::optional<double> installed = scenario.drill.thrust;
    if (needed && installed && *installed < *needed)
        alerts.push_back({AlertLevel::warning, "thrust_below_needed", "drill.thrust",
                          "The installed thrust of " + rounded(*installed / 1000) + " kN is below the " +
                              rounded(*needed / 1000) +
                              " kN that these blows need: the bit will leave the rock between blows."});
    if (summary.cor > 1 + summary.corError)
        alerts.push_back({AlertLevel::information, "super_rebound", "",
                          "The rod leaves with more momentum than it came with (e = " + rounded(summary.cor) +
                              "): rigid rock, e = 1, would underestimate the thrust."});
    if (summary.corError > promisedError)
        alerts.push_back({AlertLevel::warning, "reduced_accuracy", "",
                          "The numerical error of e may be as large as " + rounded(summary.corError) + "."});
    return alerts;
}

}  // namespace drillwave
