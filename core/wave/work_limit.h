// SPDX-License-Identifier: GPL-3.0-or-later
// Reasons why a blow or a sequence of blows is not solved because of the work limit; a larger limit removes
// them.
#pragma once

#include <algorithm>

#include "core/text/message.h"

namespace drillwave {

/// Texts for the user that say which work limit was reached (Hindrance::workLimit). isWorkLimit() recognises
/// these texts in stored results, which contain no Hindrance.
struct WorkLimitReason {
    static constexpr const char* pieces = translatable(
        "its waves have more polynomial pieces than the work limit permits, because of very many "
        "reflections; a stiffer rock, a larger gamma or a shorter blow needs fewer");
    static constexpr const char* steps = translatable(
        "it takes more computing steps than the work limit permits: try fewer sections, lengths with a "
        "common divisor or a shorter end_time");
    static constexpr const char* events = translatable(
        "contacts change too often, or a bit mass oscillates too fast: try softer rock, a larger gamma, no "
        "bit mass or a shorter end_time");
    static constexpr const char* sequence =
        translatable("its sequence of blows takes more computing steps than the work limit permits");
    static constexpr const char* contacts = translatable(
        "its blows would take %1 computing steps, more than the work limit of %2, because contact changes "
        "very often; a larger gamma, fewer blows or a higher frequency take less");
};

/// Returns whether a message says that a limit of computing work was reached. This is true for the texts of
/// WorkLimitReason, and for messages that contain one, such as "3 rows: REASON".
inline bool isWorkLimit(const Message& reason) {
    using Reason = WorkLimitReason;
    const auto patterns = {Reason::pieces, Reason::steps, Reason::events, Reason::sequence, Reason::contacts};
    return std::ranges::find(patterns, reason.pattern) != patterns.end() ||
           std::ranges::any_of(reason.arguments, isWorkLimit);
}

}  // namespace drillwave
