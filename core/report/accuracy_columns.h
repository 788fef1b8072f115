// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of the accuracy study, for a uniform rod and for a drill string. Text table, JSON and CSV use the
// same ones.
#pragma once

#include <array>
#include <string_view>

#include "core/report/study_column.h"
#include "core/study/proof/accuracy.h"
#include "core/study/proof/string_accuracy.h"

namespace drillwave {

inline constexpr auto accuracyColumns = std::to_array<StudyColumn<AccuracyRow>>({
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

inline constexpr auto stringAccuracyColumns = std::to_array<StudyColumn<StringAccuracyRow>>({
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

/// Returns how a lattice stores the waves in its segments: "moved" (shifted by one segment in each time step)
/// or "ring" (ring buffer, without shifting). Empty for methods that are not a lattice.
inline std::string_view wavesName(const AccuracyRow& row) {
    if (row.choice.method != Method::lattice) return {};
    return row.choice.lattice.waves == LatticeWaves::moved ? "moved" : "ring";
}

}  // namespace drillwave
