// SPDX-License-Identifier: GPL-3.0-or-later
// The comment lines with which the scenario of a result begins: who solved it, and how.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/blow/method.h"

namespace drillwave {

/// How a CSV file that begins with its scenario begins.
inline constexpr std::string_view csvRemarksBegin = "# # Written by Drillwave ";

/// Content of the remarks; all empty for a text that does not begin with them.
struct ResultRemarks {
    std::string version;
    std::optional<MethodChoice> method;
    std::size_t length = 0;  ///< bytes of these lines
    Message problem;         ///< a method that is none of this program; empty when it is
};

/// The lines, as comments of a YAML file; `columns` says what the columns of a CSV file mean, and is left out
/// where it is empty, as `method` is.
std::string remarksText(std::string_view about, std::string_view method, std::string_view columns = {});

/// Reads them at the top of a YAML text, behind a byte order mark where it has one.
ResultRemarks remarksOf(std::string_view yaml);

}  // namespace drillwave
