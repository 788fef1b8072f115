// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/prepared_record.h"

#include <algorithm>
#include <cmath>

#include "core/study/identify/even_samples.h"
#include "core/study/identify/gauge_pair.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

constexpr std::size_t leastZeroSamples = 50;
constexpr double frontMargin = 20e-6;         ///< zero ends that long before the front [s]
constexpr double quietShare = 0.15;           ///< of the peak: below that for 20 µs the blow is over
constexpr double quietSpan = 20e-6;           ///< [s]
constexpr double arrivalShare = 0.22;         ///< of the peak: the reflection
constexpr double longestPairWindow = 1.4e-3;  ///< of two gauges after the reflection [s]
constexpr double defaultPlaceTolerance = 5e-3;
constexpr double longestPause = 5e-6;  ///< within f that a line may bridge [s]
constexpr double bridgedMost = 0.05;   ///< force that a line may bridge for longer, share of the peak
constexpr double clippedMost = 5e-6;   ///< of the incident wave [s]

std::string microseconds(double seconds) {
    return formatNumber(std::round(seconds * 1e7) / 10) + " us";
}

Preparation refused(PreparedRecord record, const char* code, Message text) {
    return {std::move(record), RecordRefusal{code, std::move(text)}};
}

/// Waves before the front that the noise does not explain, share of the peak (theory §13).
double wavesBefore(const PreparedGauge& gauge, std::size_t quiet, double step, double peak) {
    const auto span = std::max<std::size_t>(2, static_cast<std::size_t>(40e-6 / step + 0.5));
    if (quiet < 4 * span) return 0;
    const std::vector<double>& p = gauge.force;
    double sum = 0, power = 0;
    for (std::size_t i = 0; i < quiet; ++i) {
        sum += p[i];
        if (i >= span) sum -= p[i - span];
        if (i + 1 >= span) power += std::pow(sum / static_cast<double>(span), 2);
    }
    const double slow = power / static_cast<double>(quiet - span + 1);
    // white noise of the same fast part: an autoregressive model learns slow waves as noise
    double fast = 0;
    for (std::size_t i = 1; i < quiet; ++i) fast += std::pow(p[i] - p[i - 1], 2);
    const double white = std::sqrt(fast / (2 * static_cast<double>(quiet - 1)) / static_cast<double>(span));
    const double expected = std::min(gauge.noise.deviationOfMean(span),
                                     std::max(3 * white, 0.5 * gauge.noise.deviationOfMean(span)));
    const double independent = static_cast<double>(quiet) / static_cast<double>(span);
    double found = 0;
    if (slow > expected * expected * (1 + 3 * std::sqrt(2 / independent)))
        found = std::sqrt(2 * (slow - expected * expected)) / peak;
    double first = 0, second = 0;
    for (std::size_t i = 0; i < quiet; ++i) (2 * i < quiet ? first : second) += p[i];
    const double difference = 2 * std::abs(first - second) / static_cast<double>(quiet);
    const double error = 2 * gauge.noise.deviationOfMean(quiet / 2);
    if (difference > 4 * error) found = std::max(found, difference / 2 / peak);
    return found;
}

/// A front behind fewer samples than a level needs: the largest step of the record, if it is among them.
FrontFound earlyFront(const std::vector<double>& force, std::size_t from, std::size_t to) {
    constexpr std::size_t levelSamples = 3;
    FrontFound found;
    if (to - from < leastZeroSamples) return found;
    for (std::size_t i = from; i < from + levelSamples; ++i) found.zero += force[i] / levelSamples;
    for (std::size_t i = from; i < to; ++i)
        found.peak = std::max(found.peak, std::abs(force[i] - found.zero));
    for (std::size_t i = from; i < from + levelSamples; ++i)
        if (std::abs(force[i] - found.zero) > 0.05 * found.peak) return found;
    for (std::size_t i = from; i < to && !found.isFound; ++i)
        if (std::abs(force[i] - found.zero) > 0.2 * found.peak) {
            found.front = i;
            found.isFound = i - from < leastZeroSamples;
        }
    return found;
}

double peakBetween(const PreparedRecord& record, double from, double to) {
    double peak = 0;
    for (std::size_t i = record.front; i < record.count(); ++i) {
        const double t = record.timeOf(i);
        if (t >= from && t < to) peak = std::max(peak, std::abs(record.gauges.front().force[i]));
    }
    return peak;
}

/// From where |P| has been below 15 % of the peak for 20 µs; nothing before `end`.
std::optional<double> quietBefore(const PreparedRecord& record, double end) {
    double since = -1;
    for (std::size_t i = record.front; i < record.count() && record.timeOf(i) < end; ++i) {
        const double t = record.timeOf(i);
        if (std::abs(record.gauges.front().force[i]) > quietShare * record.peak || t < quietSpan)
            since = -1;
        else if (since < 0)
            since = t;
        if (since >= 0 && t - since >= quietSpan) return t;
    }
    return std::nullopt;
}

double seenArrival(const PreparedRecord& record, double quietFrom, double deviation) {
    const double threshold = std::max(arrivalShare * record.peak, 6 * deviation);
    const double from = std::max(quietFrom, 0.8 * record.roundTrip);
    for (std::size_t i = record.front; i < record.count(); ++i) {
        const double t = record.timeOf(i);
        if (t < from) continue;
        if (t > 1.2 * record.roundTripToRock()) break;
        if (std::abs(record.gauges.front().force[i]) > threshold) return t;
    }
    return 0;
}

double validEnd(const PreparedRecord& record, const IdentifyQuestion& question) {
    double end = record.timeOf(record.count() - 1);
    const GaugePlace& near = record.places.front();
    const double arrival = record.roundTrip + record.shift;
    if (record.isPair())
        end = std::min(end, arrival + longestPairWindow);
    else
        end = std::min(end, arrival + 2 * near.behind / near.waveSpeed - 12e-6);
    if (question.end) end = std::min(end, record.roundTripToRock() + record.shift + *question.end);
    return end;
}

}  // namespace

double placeTolerance(const IdentifyQuestion& question) {
    for (const KnownTolerance& known : question.known)
        if (known.key == "gauge") return known.tolerance;
    return defaultPlaceTolerance;
}

Preparation prepareRecord(const GaugeRecord& given, const std::vector<GaugePlace>& places,
                          const IdentifyQuestion& question, std::size_t blow, ArrivalChoice arrival) {
    PreparedRecord record;
    record.places = places;
    for (GaugePlace& place : record.places) place.end.barBehind = question.barBehind;
    if (given.time.size() < leastZeroSamples)
        return refused(std::move(record), "too_short",
                       {translatable("the record has %1 samples; at least 50 are needed before the front"),
                        {std::to_string(given.time.size())}});
    EvenSamples even = evenSamples(given);
    record.step = even.step;
    // The far gauge sees the front first and tells where blows begin.
    const std::size_t leader = given.gauges.size() - 1;
    const auto ranges = blowRanges(even.force[leader], even.step);
    if (blow >= ranges.size())
        return refused(std::move(record), "no_front", translatable("there is no such blow in the record"));
    const auto [from, to] = ranges[blow];
    record.furtherBlows = ranges.size() - 1 - blow;
    if (record.furtherBlows > 0 && !question.allBlows) record.remarks.emplace_back("further_blows");
    FrontFound first = findFront(even.force[leader], from, to, even.step);
    if (!first.isFound) first = earlyFront(even.force[leader], from, to);
    double largest = 0;
    for (std::size_t i = from; i < to; ++i) largest = std::max(largest, std::abs(even.force[leader][i]));
    if (!first.isFound || !(first.peak > 1e-9 * largest) || first.peak == 0)
        return refused(
            std::move(record), "no_front",
            translatable("no front is seen in the record; check the gauge, its column and the trigger"));
    const auto margin = static_cast<std::size_t>(frontMargin / even.step + 0.5);
    record.quiet = first.front - from > margin ? first.front - from - margin : 0;
    if (first.front - from < leastZeroSamples)
        return refused(
            std::move(record), "short_zero",
            {translatable("only %1 samples stand before the front at %2; record at least 50 before it "
                          "(trigger with more pre-trigger time)"),
             {std::to_string(first.front - from),
              microseconds(even.start + static_cast<double>(first.front) * even.step)}});
    record.quiet = std::max<std::size_t>(record.quiet, std::min<std::size_t>(first.front - from, 20));
    std::vector<FrontFound> fronts(given.gauges.size(), first);
    for (std::size_t g = 0; g < given.gauges.size(); ++g)
        fronts[g] = findFront(even.force[g], from, to, even.step);
    for (const FrontFound& front : fronts)
        if (!front.isFound)
            return refused(std::move(record), "no_front",
                           translatable("one of the gauges sees no front; check its column and its cable"));
    if (fronts.size() == 2) {
        const double late =
            (static_cast<double>(fronts[0].front) - static_cast<double>(fronts[1].front)) * even.step;
        if (late < -0.3 * (places[1].ahead - places[0].ahead) / places[0].waveSpeed)
            return refused(
                std::move(record), "exchanged",
                translatable("the front reaches the gauge near the bit first: are the columns of the "
                             "two gauges exchanged? Exchange them in --gauge"));
    }
    const std::size_t near = fronts[0].front;
    record.front = near - from;
    record.startTime = even.start + static_cast<double>(near) * even.step;

    double sum = 0;
    const auto early = std::min<std::size_t>(to, near + static_cast<std::size_t>(60e-6 / even.step) + 3);
    for (std::size_t i = near; i < early; ++i) sum += even.force[0][i] - fronts[0].zero;
    record.sign = sum < 0 ? -1 : 1;
    for (std::size_t g = 0; g < given.gauges.size(); ++g) {
        PreparedGauge gauge;
        gauge.recorderStep = even.recorderStep[g];
        double zero = 0;
        for (std::size_t i = from; i < from + record.quiet; ++i) zero += even.force[g][i];
        zero /= static_cast<double>(record.quiet);
        gauge.zero = zero;
        for (std::size_t i = from; i < to; ++i)
            gauge.force.push_back(record.sign * (even.force[g][i] - zero));
        if (!even.opposite[g].empty()) {
            double other = 0;
            for (std::size_t i = from; i < from + record.quiet; ++i) other += even.opposite[g][i];
            other /= static_cast<double>(record.quiet);
            for (std::size_t i = from; i < to; ++i) gauge.opposite.push_back(even.opposite[g][i] - other);
        }
        record.gauges.push_back(std::move(gauge));
    }

    const double tolerance = placeTolerance(question), speed = places[0].waveSpeed;
    record.roundTrip = 2 * places[0].ahead / speed;
    record.peak = peakBetween(record, 0, std::max(record.roundTrip - 8e-6, 30e-6));
    for (PreparedGauge& gauge : record.gauges) {
        const double least = std::max(gauge.recorderStep / std::sqrt(12), 1e-7 * record.peak);
        gauge.noise = GaugeNoise(std::span(gauge.force).first(record.quiet), record.step, least);
        record.before = std::max(record.before, wavesBefore(gauge, record.quiet, record.step, record.peak));
    }
    if (record.before > 0.01) record.remarks.emplace_back("not_quiet_before");
    const double deviation = record.gauges[0].noise.deviation();

    if (!record.isPair()) {
        const double margins = 8e-6 + 2 * tolerance / speed;
        std::optional<double> quiet = quietBefore(record, 1.2 * record.roundTrip);
        record.quietFrom = quiet.value_or(record.roundTrip);
        if (arrival == ArrivalChoice::seen) record.arrival = seenArrival(record, record.quietFrom, deviation);
        if (record.arrival > 0) {
            const double allowed = 25e-6 + 2 * tolerance / speed;
            if (record.arrival < record.roundTrip - allowed) record.shift = record.arrival - record.roundTrip;
            if (record.arrival > record.roundTripToRock() + allowed)
                record.shift = record.arrival - record.roundTripToRock();
        }
        record.incidentEnd = record.roundTrip + record.shift - margins;
        if (record.arrival > 0) record.incidentEnd = std::min(record.incidentEnd, record.arrival - 15e-6);
        // A blow that falls just when its reflection must arrive is cut by it.
        const bool isCut = quiet && *quiet - quietSpan > record.roundTrip - margins;
        if (!quiet || isCut || *quiet > record.incidentEnd)
            return refused(
                std::move(record), "blow_not_over",
                {translatable("the blow is not over when its reflection arrives after %1; a second gauge "
                              "further from the bit is needed, or a gauge further away"),
                 {microseconds(record.roundTrip)}});
        if (record.incidentEnd - record.quietFrom < 60e-6) record.remarks.emplace_back("quiet_short");
    } else {
        record.transit = (places[1].ahead - places[0].ahead) / speed;
        matchSecondGauge(record);
        if (record.secondGain < 0) record.remarks.emplace_back("second_reversed");
        record.incidentEnd = record.roundTrip - 8e-6;
    }

    record.end = validEnd(record, question);
    if (even.gap && even.gap->first < record.startTime + record.end)
        return refused(std::move(record), "gap",
                       {translatable("samples are missing from %1 to %2; record without a pause"),
                        {microseconds(even.gap->first), microseconds(even.gap->second)}});
    const double begin = record.roundTripToRock() + record.shift;
    if (record.end <= begin)
        return refused(
            std::move(record), "too_short",
            {translatable("the record ends before the reflection arrives, %1 after the front; record longer"),
             {microseconds(begin)}});
    if ((record.end - begin) < leastZeroSamples * record.step)
        return refused(
            std::move(record), "too_short",
            {translatable("only %1 samples show the reflection, in a window of %2; at least 50 are needed: "
                          "record faster or longer, or put the gauge further from the end behind it"),
             {std::to_string(static_cast<int>((record.end - begin) / record.step)),
              microseconds(record.end - begin)}});
    for (std::size_t g = 0; g < given.gauges.size(); ++g) {
        if (even.isClipped[g].empty() ||
            !(record.gauges[g].noise.deviation() > record.gauges[g].recorderStep / 2))
            continue;
        double inBlow = 0;
        std::vector<bool> lost(record.count(), false);
        bool any = false;
        for (std::size_t i = from; i < to; ++i) {
            if (!even.isClipped[g][i]) continue;
            const double t = record.timeOf(i - from);
            if (t < (record.isPair() ? record.end : record.incidentEnd)) inBlow += record.step;
            if (t > record.end) continue;
            any = true;
            for (std::size_t k = i - from >= 6 ? i - from - 6 : 0; k <= i - from + 6 && k < lost.size(); ++k)
                lost[k] = true;
        }
        if (inBlow > clippedMost)
            return refused(
                std::move(record), "clipped",
                {translatable("the incident wave is clipped over %1; choose a larger range of the amplifier "
                              "or of the recorder"),
                 {microseconds(inBlow)}});
        if (any) {
            record.isLost = std::move(lost);
            record.remarks.emplace_back("clipped");
        }
    }
    // A line across a pause is no measurement: in f it drives the model, in b it would be compared.
    const auto missing = [&](std::size_t i) { return i < even.isMissing.size() && even.isMissing[i]; };
    for (std::size_t i = near; i < to && record.timeOf(i - from) <= record.end; ++i) {
        if (!missing(i)) continue;
        std::size_t last = i;
        while (last + 1 < to && missing(last + 1)) ++last;
        const double pausedAt = record.timeOf(i - from),
                     paused = static_cast<double>(last - i + 1) * record.step;
        const bool drives = record.isPair() || pausedAt < record.incidentEnd;
        double bridged = 0;  // beside and across the pause
        for (const PreparedGauge& gauge : record.gauges)
            for (std::size_t k = i - from - 1; k <= std::min(last - from + 1, gauge.force.size() - 1); ++k)
                bridged = std::max(bridged, std::abs(gauge.force[k]));
        if (drives && paused > std::max(longestPause, 3.5 * record.step) &&
            bridged > bridgedMost * record.peak)
            return refused(std::move(record), "gap",
                           {translatable("samples are missing from %1 to %2; record without a pause"),
                            {microseconds(record.startTime + pausedAt),
                             microseconds(record.startTime + pausedAt + paused)}});
        if (!drives) {
            record.isLost.resize(record.count(), false);
            for (std::size_t k = i; k <= last && k - from < record.isLost.size(); ++k)
                record.isLost[k - from] = true;
        }
        i = last;
    }
    // Nothing behind the window is looked at again.
    const auto used =
        record.front + static_cast<std::size_t>(std::max(0.0, record.end + 100e-6) / record.step);
    for (PreparedGauge& gauge : record.gauges) {
        gauge.force.resize(std::min(gauge.force.size(), used));
        if (!gauge.opposite.empty()) gauge.opposite.resize(gauge.force.size());
    }
    if (!record.isLost.empty()) record.isLost.resize(record.count());
    const PreparedGauge& near0 = record.gauges[0];
    if (!near0.opposite.empty()) {
        double power = 0;
        std::size_t count = 0;
        for (std::size_t i = record.front; i < record.count() && record.timeOf(i) < record.end; ++i, ++count)
            power += near0.opposite[i] * near0.opposite[i];
        record.bending =
            std::sqrt(power / static_cast<double>(std::max<std::size_t>(count, 1))) / record.peak;
    }
    const double stress = record.peak * places[0].youngsModulus / places[0].axialStiffness;
    if (stress < 15e6 || stress > 1e9) {
        constexpr double usualStress = 200e6;  // [Pa]
        record.remarks.emplace_back("unit_doubtful");
        record.gapScale = stress / usualStress;
    }
    return {std::move(record), std::nullopt};
}

}  // namespace drillwave
