#include "core/file/blow_csv.h"

#include <algorithm>

#include "core/model/version.h"
#include "core/study/row_text.h"
#include "core/wave/wave_field.h"

namespace drillwave {

namespace {

std::string heading(std::string_view name, Quantity quantity, OutputUnits units) {
    if (units == OutputUnits::dimensionless) return std::string(name);
    return std::string(name) + " [" + std::string(unitsOf(quantity).front().name) + "]";
}

/// The first line of a text, which is removed from it.
std::string_view takeLine(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

}  // namespace

std::string scenarioHeader(std::string_view scenarioYaml, std::string_view method) {
    std::string header = "# # Written by Drillwave " + std::string(versionText) +
                         "; without the leading \"# \" these lines are the scenario.\n";
    if (!method.empty()) header += "# # Solved by " + std::string(method) + ".\n";
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (scenarioYaml.starts_with(byteOrderMark)) scenarioYaml.remove_prefix(byteOrderMark.size());
    while (!scenarioYaml.empty()) {
        const std::string_view line = takeLine(scenarioYaml);
        header += line.empty() ? "#" : "# ";
        header += line;
        header += '\n';
    }
    return header;
}

std::string scenarioFromHeader(std::string_view csv) {
    std::string scenario;
    while (csv.starts_with('#')) {
        std::string_view line = takeLine(csv).substr(1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.starts_with(' ')) line.remove_prefix(1);
        scenario += line;
        scenario += '\n';
    }
    return scenario;
}

std::string historiesCsv(const Impact& impact, const PulseForce& pulse, OutputUnits units,
                         const Scales& scales) {
    const bool si = units == OutputUnits::si;
    const double time = si ? scales.time : 1;
    const double force = si ? scales.force : 1;
    const double impulse = si ? scales.impulse : 1;
    const SampledHistory history = sampleHistory(impact);
    std::string csv =
        heading("time", Quantity::time, units) + "," + heading("impact_force", Quantity::force, units) + "," +
        heading("impulse", Quantity::impulse, units) + "," + heading("momentum", Quantity::impulse, units) +
        "," + heading("incident_wave", Quantity::force, units) + "\n";
    for (std::size_t i = 0; i < history.time.size(); ++i) {
        const double received = pulse.isRigidBody() ? 1 : pulse.impulseUntil(history.time[i]);
        const double cells[] = {history.time[i] * time, history.force[i] * force,
                                history.impulse[i] * impulse, (received - history.impulse[i]) * impulse,
                                history.incident[i] * force};
        for (const double& cell : cells) {
            if (&cell != cells) csv += ',';
            appendNumber(csv, cell);
        }
        csv += '\n';
    }
    return csv;
}

std::string eventsCsv(const Impact& impact, OutputUnits units, const Scales& scales) {
    const double scale = units == OutputUnits::si ? scales.time : 1;
    std::string csv = "kind," + heading("time", Quantity::time, units) + "\n";
    for (const ImpactEvent& event : impact.events) {
        csv += name(event.kind);
        csv += ',';
        appendNumber(csv, event.time * scale);
        csv += '\n';
    }
    return csv;
}

std::string_view name(ContactEvent event) {
    switch (event) {
        case ContactEvent::contact:
            return "contact";
        case ContactEvent::unloading:
            return "unloading";
        case ContactEvent::primaryLoading:
            return "primary_loading";
        case ContactEvent::separation:
            return "separation";
    }
    return {};
}

}  // namespace drillwave
