// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/known_sizes.h"

#include <algorithm>
#include <cmath>

#include "core/text/units.h"

namespace drillwave {

namespace {

constexpr double diameterTolerance = 0.5e-3;  ///< [m], and of bores
constexpr double lengthTolerance = 1e-3;      ///< [m]
constexpr double modulusTolerance = 0.01;     ///< relative
constexpr double densityTolerance = 0.005;    ///< relative

std::string underscored(std::string_view text) {
    std::string result(text);
    std::replace(result.begin(), result.end(), ' ', '_');
    return result;
}

/// Whether a key such as "string.bit_head.diameter" or "string.7.diameter" names this section, and its field.
std::string fieldOf(const std::string& key, const SizedSection& section, std::size_t place) {
    const std::size_t dot = key.rfind('.');
    if (dot == std::string::npos) return {};
    const std::string head = underscored(key.substr(0, dot)), field = key.substr(dot + 1);
    const bool isSame = head == section.key || head == "string." + underscored(section.name) ||
                        head == "string." + std::to_string(place);
    return isSame ? field : std::string();
}

struct PlacedSize {
    const SizedSection* section;
    std::size_t place;  ///< in the string, from 1
    bool isOfGauge;
    std::size_t index;
};

std::vector<PlacedSize> sectionsOf(const GaugePlace& place) {
    std::vector<PlacedSize> all{{&place.section, place.index + 1, true, 0}};
    for (std::size_t j = 0; j < place.towardsBit.size(); ++j)
        all.push_back({&place.towardsBit[j], place.index + 2 + j, false, j});
    return all;
}

const KnownTolerance* toldOf(const IdentifyQuestion& question, const PlacedSize& at, std::string_view field) {
    const KnownTolerance* told = nullptr;
    for (const KnownTolerance& known : question.known)
        if (fieldOf(known.key, *at.section, at.place) == field) told = &known;
    return told;
}

}  // namespace

std::vector<KnownSize> knownSizes(const IdentifyQuestion& question, const GaugePlace& place) {
    std::vector<KnownSize> sizes;
    for (const PlacedSize& at : sectionsOf(place)) {
        const SizedSection& section = *at.section;
        const double outer = section.diameter, inner = section.bore;
        const double squares = outer * outer - inner * inner;
        const auto add = [&](const char* field, double value, double tolerance, double perUnit) {
            KnownSize size{section.key + "." + field, "m", value, tolerance, true, at.isOfGauge, at.index, 0};
            if (const KnownTolerance* told = toldOf(question, at, field)) {
                size.tolerance = told->tolerance;
                size.isAssumed = false;
            }
            size.impedance = perUnit * size.tolerance;
            sizes.push_back(std::move(size));
        };
        if (section.isGivenByArea) {
            const double area = outer * outer * 0.785398163397448;
            add("area", area, 2 * diameterTolerance / outer * area, 1 / area);
            sizes.back().unit = "m^2";
        } else {
            add("diameter", outer, diameterTolerance, 2 * outer / squares);
            if (inner > 0) add("bore", inner, diameterTolerance, 2 * inner / squares);
        }
        if (!at.isOfGauge) add("length", section.length, std::min(lengthTolerance, 0.5 * section.length), 0);
    }
    return sizes;
}

SizeTolerances sizeTolerances(const std::vector<KnownSize>& sizes, const GaugePlace& place) {
    SizeTolerances tolerances;
    tolerances.lengths.assign(place.towardsBit.size(), 0);
    tolerances.impedances.assign(place.towardsBit.size(), 0);
    for (const KnownSize& size : sizes) {
        if (size.isOfGauge)
            tolerances.impedance = std::hypot(tolerances.impedance, size.impedance);
        else if (size.impedance > 0)
            tolerances.impedances[size.section] =
                std::hypot(tolerances.impedances[size.section], size.impedance);
        else
            tolerances.lengths[size.section] = size.tolerance;
    }
    return tolerances;
}

KnownSize materialTolerance(const IdentifyQuestion& question, const GaugePlace& place) {
    KnownSize size{"material", "1", 1, 0, true, true, 0, 0};
    double modulus = modulusTolerance, density = densityTolerance;
    for (const KnownTolerance& known : question.known) {
        const std::string field = fieldOf(known.key, place.section, place.index + 1);
        if (field == "youngs_modulus" || known.key == "material.youngs_modulus")
            modulus = known.tolerance, size.isAssumed = false;
        if (field == "density" || known.key == "material.density")
            density = known.tolerance, size.isAssumed = false;
    }
    size.tolerance = std::hypot(modulus / 2, density / 2);
    size.impedance = size.tolerance;
    return size;
}

std::vector<Message> knownProblems(const IdentifyQuestion& question, const GaugePlace& place) {
    std::vector<Message> problems;
    const std::vector<KnownSize> sizes = knownSizes(question, place);
    for (const KnownTolerance& known : question.known) {
        if (known.key == "gain" || known.key == "zero" || known.key == "gauge") {
            const double most = known.key == "gauge" ? place.ahead : 1;
            if (known.tolerance >= most)
                problems.push_back(
                    {translatable("--known %1: the tolerance must be smaller than the value"), {known.key}});
            continue;
        }
        bool isThere = known.key == "material.youngs_modulus" || known.key == "material.density";
        double value = 1;
        for (const PlacedSize& at : sectionsOf(place)) {
            const std::string field = fieldOf(known.key, *at.section, at.place);
            if (field.empty()) continue;
            if (field == "youngs_modulus" || field == "density") isThere = at.isOfGauge || isThere;
            if (field == "length" && at.isOfGauge) isThere = true, value = at.section->length;
            for (const KnownSize& size : sizes)
                if (size.key == at.section->key + "." + field) isThere = true, value = size.value;
        }
        if (!isThere)
            problems.push_back(
                {translatable("--known %1: is no size of the gauge's section or of a section between "
                              "gauge and rock; give gain, zero, gauge, or such a key"),
                 {known.key}});
        else if (known.tolerance >= value)
            problems.push_back(
                {translatable("--known %1: the tolerance must be smaller than the value"), {known.key}});
    }
    return problems;
}

}  // namespace drillwave
