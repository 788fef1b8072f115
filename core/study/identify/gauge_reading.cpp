// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/gauge_reading.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

namespace {

constexpr double leastGaugeDistance = 0.5;  ///< between two gauges [m]

/// One column as force in N, whatever its sign.
struct ColumnRead {
    std::vector<double> time, force;
};

bool readColumn(std::istream& in, SignalOptions options, const std::string& column, const GaugePlace& place,
                const std::stop_token& stop, ColumnRead& read, GaugeReading& result) {
    options.signalColumn = column;
    options.zero.reset();
    options.from.reset();
    options.to.reset();
    SignalBar bar;
    bar.modulus = place.youngsModulus;
    bar.area = place.axialStiffness / place.youngsModulus;
    bar.impedance = place.end.impedance;
    in.clear();
    in.seekg(0);
    SignalReading reading = readSignal(in, options, bar, stop);
    if (!reading.problem.isEmpty()) {
        result.problem = about(column, reading.problem);
        result.isWrongOption = reading.isWrongOption;
        return false;
    }
    if (reading.isOpen() || !reading.hasForce() || !reading.isTimeKnown()) {
        result.questions = reading.questions;
        if (result.questions.empty()) result.questions.emplace_back("unit");
        return false;
    }
    read.time = std::move(reading.samples.time);
    read.force = std::move(reading.samples.value);
    const double factor = std::abs(reading.forcePerNumber);
    for (double& value : read.force) value *= factor;
    return true;
}

double powerOf(const std::vector<double>& values) {
    double mean = 0, power = 0;
    for (const double value : values) mean += value;
    mean /= static_cast<double>(std::max<std::size_t>(values.size(), 1));
    for (const double value : values) power += (value - mean) * (value - mean);
    return power;
}

}  // namespace

std::vector<GaugePlace> gaugePlaces(const Scenario& scenario, const std::vector<GaugeChoice>& gauges) {
    std::vector<GaugePlace> places;
    for (const GaugeChoice& gauge : gauges)
        if (std::optional<GaugePlace> place = gaugePlace(scenario, gauge.distance))
            places.push_back(std::move(*place));
    return places;
}

Message gaugePairProblem(const std::vector<GaugeChoice>& gauges, const std::vector<GaugePlace>& places) {
    std::vector<std::string> columns;
    for (const GaugeChoice& gauge : gauges)
        for (const std::string& column : {gauge.column, gauge.opposite}) {
            if (!column.empty() && std::ranges::find(columns, column) != columns.end())
                return {translatable("column %1 is given twice; every gauge has a column of its own"),
                        {column}};
            columns.push_back(column);
        }
    if (gauges.size() < 2) return {};
    if (places[0].index != places[1].index)
        return translatable("both gauges must be on one section of the string");
    if (std::abs(gauges[0].distance - gauges[1].distance) < leastGaugeDistance)
        return translatable("two gauges must be at least 0.5 m apart");
    return {};
}

GaugeReading readGauges(std::istream& in, const SignalOptions& options,
                        const std::vector<GaugeChoice>& gauges, const std::vector<GaugePlace>& places,
                        const std::stop_token& stop, const std::string& behind) {
    GaugeReading result;
    for (std::size_t g = 0; g < gauges.size(); ++g) {
        ColumnRead one, other;
        if (!readColumn(in, options, gauges[g].column, places[g], stop, one, result)) return result;
        GaugeChannel channel{gauges[g].name(), gauges[g].distance, std::move(one.force), {}};
        if (!gauges[g].opposite.empty()) {
            if (!readColumn(in, options, gauges[g].opposite, places[g], stop, other, result)) return result;
            if (other.force.size() != channel.force.size()) {
                result.problem =
                    translatable("the columns of the two gauges have different numbers of samples");
                return result;
            }
            channel.opposite.resize(channel.force.size());
            for (std::size_t i = 0; i < channel.force.size(); ++i) {
                const double a = channel.force[i], b = other.force[i];
                channel.force[i] = (a + b) / 2;
                channel.opposite[i] = (a - b) / 2;
            }
            if (powerOf(channel.opposite) > powerOf(channel.force)) {
                result.problem = {
                    translatable("%1: the opposite gauges have opposite signs; reverse one of them"),
                    {channel.name}};
                return result;
            }
        }
        result.record.time = std::move(one.time);
        result.record.gauges.push_back(std::move(channel));
    }
    if (!behind.empty()) {
        ColumnRead read;
        if (!readColumn(in, options, behind, places.front(), stop, read, result)) return result;
        if (read.force.size() != result.record.time.size()) {
            result.problem = {translatable("%1: has another number of samples than the gauges"), {behind}};
            return result;
        }
        result.record.behind = std::move(read.force);
    }
    std::stable_sort(result.record.gauges.begin(), result.record.gauges.end(),
                     [](const GaugeChannel& a, const GaugeChannel& b) { return a.distance < b.distance; });
    return result;
}

}  // namespace drillwave
