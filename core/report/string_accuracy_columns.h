// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a row of the accuracy study of a drill string, named once for its tables, JSON and CSV.
#pragma once

#include <array>
#include <string_view>

#include "core/report/accuracy_columns.h"
#include "core/study/proof/string_accuracy.h"

namespace drillwave {

struct StringAccuracyColumn {
    std::string_view key;    ///< JSON key and CSV column
    std::string_view title;  ///< in a table
    NumberStyle style;
    double (*value)(const StringAccuracyRow&);  ///< NaN: none
};

inline constexpr auto stringAccuracyColumns = std::to_array<StringAccuracyColumn>({
    {"cell_s", "cell", NumberStyle::time, [](const StringAccuracyRow& r) { return r.cell; }},
    {"error_efficiency", "error", NumberStyle::error, [](const StringAccuracyRow& r) { return r.error; }},
    {"efficiency_error", "stated", NumberStyle::error, [](const StringAccuracyRow& r) { return r.stated; }},
    {"error_impulse", "impulse", NumberStyle::error,
     [](const StringAccuracyRow& r) { return r.impulseError; }},
    {"cells", "cells x nodes", NumberStyle::count,
     [](const StringAccuracyRow& r) { return double(r.cells); }},
    {"median_s", "median", NumberStyle::time, [](const StringAccuracyRow& r) { return r.time.median; }},
    {"min_s", "minimum", NumberStyle::time, [](const StringAccuracyRow& r) { return r.time.least; }},
});

}  // namespace drillwave
