// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/identify_answer.h"

#include <algorithm>

namespace drillwave {

std::string_view name(ModelVerdict verdict) {
    switch (verdict) {
        case ModelVerdict::accepted:
            return "accepted";
        case ModelVerdict::strained:
            return "strained";
        case ModelVerdict::rejected:
            break;
    }
    return "rejected";
}

std::string_view name(ParameterVerdict verdict) {
    switch (verdict) {
        case ParameterVerdict::identified:
            return "identified";
        case ParameterVerdict::uncertain:
            return "uncertain";
        case ParameterVerdict::bounded:
            return "bounded";
        case ParameterVerdict::notSeen:
            return "not_seen";
        case ParameterVerdict::rejected:
            break;
    }
    return "rejected";
}

bool RecordAnswer::has(std::string_view remark) const {
    return std::find(remarks.begin(), remarks.end(), remark) != remarks.end();
}

const IdentifiedParameter* RecordAnswer::find(std::string_view key) const {
    for (const IdentifiedParameter& parameter : parameters)
        if (parameter.key == key) return &parameter;
    return nullptr;
}

// Lengths are a cause of the error in sections between gauge and rock.
bool RecordAnswer::hasGaugeAtRock() const {
    for (const IdentifiedParameter& parameter : parameters)
        for (const BudgetRow& row : parameter.budget)
            if (row.key.ends_with(".length")) return false;
    return true;
}

std::optional<IdentifiedLaw> RecordAnswer::loadingLaw() const {
    const IdentifiedParameter* stiffness = find("bit_rock.stiffness");
    if (!stiffness || !(stiffness->value > 0)) return std::nullopt;
    IdentifiedLaw curve{stiffness->value};
    const IdentifiedParameter* force = find("bit_rock.corner.1.force");
    const IdentifiedParameter* slope = find("bit_rock.corner.1.slope");
    if (force && slope && slope->value > 0)
        curve.cornerForce = force->value, curve.cornerSlope = slope->value;
    return curve;
}

std::vector<std::pair<double, double>> RecordAnswer::incidentWave() const {
    constexpr double frontLevel = 0.005, endLevel = 0.002;  // of the peak
    const std::vector<double>& force = curves.incident;
    double largest = 0;
    for (const double each : force) largest = std::max(largest, each);
    std::size_t first = 0, last = force.size();
    while (first + 1 < force.size() && force[first] < frontLevel * largest) ++first;
    while (last > first + 1 && force[last - 1] < endLevel * largest) --last;
    std::vector<std::pair<double, double>> wave;
    for (std::size_t i = first; i < last; ++i)
        wave.emplace_back(curves.time[i] - curves.time[first], std::max(0.0, force[i]));
    return wave;
}

bool RecordAnswer::saysSomething() const {
    if (refusal || model == ModelVerdict::rejected) return false;
    for (const IdentifiedParameter& parameter : parameters) {
        const bool isMain = parameter.key == "bit_rock.stiffness" || parameter.key == "bit_rock.gamma";
        if (isMain && (parameter.verdict == ParameterVerdict::identified ||
                       parameter.verdict == ParameterVerdict::bounded))
            return true;
    }
    return law == "file";
}

}  // namespace drillwave
