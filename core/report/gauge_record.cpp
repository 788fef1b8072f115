// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/gauge_record.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/blow/blow_waves.h"
#include "core/report/report_table.h"
#include "core/study/identify/gauge_noise.h"
#include "core/study/identify/gauge_place.h"

namespace drillwave {

namespace {

constexpr int partsOfSample = 4;        // whose mean is a sample
constexpr double finestStrain = 1e-10;  // step of the values in the table: 1e-4 microstrain

/// Strain at a gauge over the times of the record, tension positive.
std::vector<double> strainAt(const Blow& blow, const BlowWaves& waves, const PlannedGauge& gauge,
                             std::size_t count) {
    const GaugePlace place = *gaugePlace(blow.scenario, gauge.distance);
    const double share = place.fromStruckEnd / (place.fromStruckEnd + gauge.distance);
    const double scale = blow.scales.force / place.axialStiffness;
    std::vector<double> strain(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        for (int part = 0; part < partsOfSample; ++part) {
            const double offset = (part + 0.5) / partsOfSample - 0.5;
            const double time = (static_cast<double>(i) + offset) / gaugeRecordRate - gaugeRecordBegin;
            if (time > 0)
                strain[i] += waves.state(share, time / blow.scales.time).normalForce * scale / partsOfSample;
        }
    }
    return strain;
}

}  // namespace

std::string gaugeRecordCsv(const Blow& blow, const std::vector<PlannedGauge>& gauges, double noise,
                           std::uint64_t seed) {
    const BlowWaves waves(blow);
    const double end = std::min(waves.end(), waves.arrival() + 2 * waves.roundTrip()) * blow.scales.time;
    const auto count = static_cast<std::size_t>((gaugeRecordBegin + end) * gaugeRecordRate);
    std::mt19937_64 random(seed);
    std::vector<std::string> headers{"time [us]"};
    std::vector<std::vector<double>> columns;
    for (const PlannedGauge& gauge : gauges) {
        headers.push_back(gauge.column + " [microstrain]");
        std::vector<double> strain = strainAt(blow, waves, gauge, count);
        double largest = 0;
        for (const double value : strain) largest = std::max(largest, std::abs(value));
        for (double& value : strain)
            value = std::round((value + noise * largest * standardNormal(random)) / finestStrain) / 1e4;
        columns.push_back(std::move(strain));
    }
    return csvText({headers, count, [&](std::size_t row) {
                        Cells cells;
                        const double samples = gaugeRecordBegin * gaugeRecordRate;
                        cells.push_back((static_cast<double>(row) - samples) / gaugeRecordRate / 1e-6);
                        for (const std::vector<double>& column : columns) cells.push_back(column[row]);
                        return cells;
                    }});
}

}  // namespace drillwave
