// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/nearest_name.h"

#include <algorithm>
#include <array>
#include <limits>

namespace drillwave {
namespace {

constexpr std::size_t maximumLength = 40;

/// Number of typing errors between two names (optimal string alignment), upper and lower case being alike.
std::size_t typingErrors(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    std::array<std::array<std::size_t, maximumLength + 1>, maximumLength + 1> errors{};
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                errors[i][j] = i + j;
                continue;
            }
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            errors[i][j] =
                std::min({errors[i - 1][j] + 1, errors[i][j - 1] + 1, errors[i - 1][j - 1] + (same ? 0 : 1)});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) errors[i][j] = std::min(errors[i][j], errors[i - 2][j - 2] + 1);
        }
    }
    return errors[a.size()][b.size()];
}

}  // namespace

std::string_view nearestName(std::string_view name, std::span<const std::string_view> candidates) {
    if (name.empty() || name.size() > maximumLength) return {};
    std::string_view nearest;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const std::string_view candidate : candidates) {
        if (candidate.size() > maximumLength) continue;
        const std::size_t dot = candidate.find('.');
        const bool bare = dot != std::string_view::npos && name == candidate.substr(dot + 1);
        const std::size_t errors = bare ? 1 : typingErrors(name, candidate);
        if (errors < fewest && 3 * errors <= std::max(name.size(), std::size_t{3})) {
            fewest = errors;
            nearest = candidate;
        }
    }
    return nearest;
}

}  // namespace drillwave
