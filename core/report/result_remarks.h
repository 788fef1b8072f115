// SPDX-License-Identifier: GPL-3.0-or-later
// Comment lines at the start of a result's scenario, which state the program version and the method.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/blow/method.h"

namespace drillwave {

/// First characters of a CSV file that begins with its scenario as comment lines. The program uses them to
/// recognise its own files.
inline constexpr std::string_view csvRemarksBegin = "# # Written by Drillwave ";

/// Program version and method with which a result was computed. They are read from comment lines at the start
/// of the scenario file in the result. All members are empty if the text does not begin with such lines.
struct ResultRemarks {
    std::string version;
    std::optional<MethodChoice> method;
    std::size_t length = 0;  ///< length of the comment lines at the start of the text [bytes]
    Message problem;         ///< error if the method is not known to this program; empty otherwise
};

/// Returns the comment lines for the start of a scenario file in a result. They contain the program version
/// followed by `about`, the method, and `columns`, which explains the columns of a CSV file. Empty `method`
/// and `columns` are omitted.
std::string remarksText(std::string_view about, std::string_view method, std::string_view columns = {});

/// Returns the contents of the comment lines at the start of a YAML text. A byte order mark before them is
/// skipped.
ResultRemarks remarksOf(std::string_view yaml);

}  // namespace drillwave
