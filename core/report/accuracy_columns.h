// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a row of the accuracy study, named once for its table, JSON and CSV.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/study/proof/accuracy.h"

namespace drillwave {

/// How a number is shown in the table.
enum class NumberStyle { error, time, count, factor, order };

struct AccuracyColumn {
    std::string_view key;    ///< JSON key and CSV column
    std::string_view title;  ///< in the table; empty: not in the table
    NumberStyle style;
    double (*value)(const AccuracyRow&);  ///< NaN: none
};

inline constexpr auto accuracyColumns = std::to_array<AccuracyColumn>({
    {"error_cor", "error of e", NumberStyle::error, [](const AccuracyRow& r) { return r.corError; }},
    {"cor_error", "estimate", NumberStyle::error, [](const AccuracyRow& r) { return r.corEstimate; }},
    {"order", "order", NumberStyle::order, [](const AccuracyRow& r) { return r.observedOrder; }},
    {"error_peak_force", "peak force", NumberStyle::error,
     [](const AccuracyRow& r) { return r.peakForceError; }},
    {"error_force", "force", NumberStyle::error, [](const AccuracyRow& r) { return r.forceError; }},
    {"error_force_mid_step", "mid-step", NumberStyle::error,
     [](const AccuracyRow& r) { return r.forceErrorInMiddles; }},
    {"pieces", "pieces", NumberStyle::count, [](const AccuracyRow& r) { return double(r.pieces); }},
    {"contacts", "", NumberStyle::count, [](const AccuracyRow& r) { return double(r.contacts); }},
    {"events", "events", NumberStyle::count, [](const AccuracyRow& r) { return double(r.events); }},
    {"median_s", "median", NumberStyle::time, [](const AccuracyRow& r) { return r.time.median; }},
    {"min_s", "minimum", NumberStyle::time, [](const AccuracyRow& r) { return r.time.least; }},
    {"runs", "runs", NumberStyle::count, [](const AccuracyRow& r) { return double(r.time.runs); }},
    {"speed", "speed", NumberStyle::factor, [](const AccuracyRow& r) { return r.speed; }},
});

/// "moved" or "ring"; empty for what is no lattice.
inline std::string_view wavesName(const AccuracyRow& row) {
    if (row.choice.method != Method::lattice) return {};
    return row.choice.lattice.waves == LatticeWaves::moved ? "moved" : "ring";
}

}  // namespace drillwave
