// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/design_text.h"

#include <algorithm>
#include <cmath>

#include "core/model/parameter.h"
#include "core/report/design_words.h"
#include "core/report/report_text.h"
#include "core/text/handy_text.h"

namespace drillwave {

namespace {

std::string rangeText(const UncertainInput& input) {
    const std::string key(input.parameter->key);
    if (input.kind == DistributionKind::percent) return key + " +-" + rounded(input.percent) + " %";
    const Quantity quantity = input.parameter->quantity;
    return key + " " + inHandyUnit(input.low, quantity) + " ... " + inHandyUnit(input.high, quantity) +
           (input.kind == DistributionKind::uniform ? "" : " " + std::string(name(input.kind)));
}

std::string variedText(const DesignStudy& study) {
    std::string uncertain;
    for (const UncertainInput& input : study.uncertain)
        uncertain += (uncertain.empty() ? "" : ", ") + rangeText(input);
    if (study.draws) {
        uncertain += (uncertain.empty() ? "" : ", ") + std::to_string(study.draws->rows()) + " draws of";
        for (const KeptParameter& parameter : study.draws->parameters)
            uncertain += " " + std::string(parameter->key);
    }
    std::string chosen;
    for (const SweepAxis& axis : study.choices)
        chosen += (chosen.empty() ? "" : ", ") + std::string(axis.key()) + " (" + std::to_string(axis.count) +
                  " values)";
    return paragraph("Uncertain: " + uncertain + ".") +
           paragraph(
               "Chosen: " + (chosen.empty() ? std::string("nothing, the design of FILE alone") : chosen) +
               (study.keepsEnergy ? "; every blow has the energy of FILE's." : ".")) +
           paragraph(std::to_string(study.designCount()) +
                     (study.designCount() == 1 ? " design, " : " designs, ") + std::to_string(study.samples) +
                     " samples each, the same for all; errors are of 95 %.");
}

std::string aimWords(const DesignAim& aim) {
    return (aim.sense == Sense::largest ? "max " : "min ") + std::string(aim.output->name) + " " +
           aim.statistic.name();
}

std::string aimedText(const DesignReport& report, const DesignAim& aim, std::size_t design) {
    const SampledValue& value = aimedValue(report, aim, design);
    std::string text = outputText(report.study, *aim.output, value.value);
    if (aim.statistic.hasError() && !std::isnan(value.value))
        text += " +- " + outputText(report.study, *aim.output, value.error(), 1);
    return text;
}

/// The number of the design that is FILE itself, where there is one.
std::optional<std::size_t> ofFile(const DesignStudy& study) {
    for (std::uint64_t d = 0; d < study.designCount(); ++d)
        if (Scenario scenario = designScenario(study, d); scenario == study.base) return d;
    return std::nullopt;
}

void addDesign(const DesignReport& report, TextGrid& grid, const std::string& title, std::size_t design) {
    std::vector<std::string> cells{title, designName(report.study, design)};
    for (const DesignAim& aim : report.study.aims) {
        const std::size_t output = report.study.placeOf(*aim.output, {}).output;
        cells.push_back(
            outputText(report.study, *aim.output, report.findings.designs[design].nominal[output]));
        cells.push_back(aimedText(report, aim, design));
    }
    if (report.findings.feasibility[design].marginal) cells.emplace_back("marginal");
    grid.add(cells);
}

std::vector<std::string> titlesOf(const DesignStudy& study, const std::string& first) {
    std::vector<std::string> titles{first, "design"};
    for (const DesignAim& aim : study.aims) {
        titles.push_back(std::string(aim.output->name) + " nominal");
        titles.push_back(aimWords(aim));
    }
    return titles;
}

std::string bestText(const DesignReport& report) {
    const BestDesigns& best = report.findings.best;
    TextGrid grid;
    grid.add(titlesOf(report.study, ""));
    addDesign(report, grid, "robust best", *best.robust);
    if (best.nominal) addDesign(report, grid, "nominal best", *best.nominal);
    if (const auto file = ofFile(report.study); file && report.study.designCount() > 1)
        addDesign(report, grid, "FILE", *file);
    return grid.text();
}

/// What it costs to be safe, and what it brings.
std::string costText(const DesignReport& report) {
    const BestDesigns& best = report.findings.best;
    if (!best.nominal || *best.nominal == *best.robust) return {};
    const DesignAim& aim = report.study.aims.front();
    const std::size_t output = report.study.placeOf(*aim.output, {}).output;
    const auto nominal = [&](std::size_t d) { return report.findings.designs[d].nominal[output]; };
    const double brings =
        aimedValue(report, aim, *best.robust).value - aimedValue(report, aim, *best.nominal).value;
    const double costs = nominal(*best.robust) - nominal(*best.nominal);
    const auto change = [&](double difference) {
        return (difference > 0 ? "+" : "") + outputText(report.study, *aim.output, difference, 3);
    };
    return paragraph(designName(report.study, *best.robust) + " in place of " +
                     designName(report.study, *best.nominal) + ": " + std::string(aim.output->name) + " " +
                     aim.statistic.name() + " " + change(brings) + ", where all is as in FILE " +
                     change(costs) + ".");
}

std::string paretoText(const DesignReport& report) {
    if (report.study.aims.size() < 2 || report.study.designCount() < 2) return {};
    TextGrid grid;
    grid.add(titlesOf(report.study, "none is better in all aims"));
    constexpr std::size_t enough = 12;
    std::size_t told = 0, all = 0;
    for (std::size_t d = 0; d < report.findings.designs.size(); ++d) {
        if (!report.findings.best.pareto[d]) continue;
        ++all;
        if (told++ < enough) addDesign(report, grid, std::to_string(d + 1), d);
    }
    std::string text = "\n" + grid.text();
    if (all > enough)
        text += paragraph("and " + std::to_string(all - enough) + " more: -o DIR writes them all.");
    return text;
}

/// A bar of the total, its filled part the first.
std::string bar(const SobolIndex& index) {
    constexpr int length = 30;
    const auto part = [](double share) {
        return static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * length));
    };
    const std::size_t filled = part(index.first.value), whole = std::max(filled, part(index.total.value));
    return std::string(filled, '#') + std::string(whole - filled, '-') + std::string(length - whole, ' ');
}

std::string sensitivityText(const DesignReport& report) {
    const DesignStudy& study = report.study;
    if (study.dimensions() < 2) return {};
    std::string text = "\nWhat is worth measuring: share of the scatter, # alone, - with others\n";
    TextGrid grid(CellAlignment::left);
    for (std::size_t o = 0; o < report.findings.sensitivity.outputs.size(); ++o) {
        const OutputSensitivity& output = report.findings.sensitivity.outputs[o];
        const std::string name(report.findings.aimed[o]->name);
        if (output.isConstant) {
            grid.add({name, "constant"});
            continue;
        }
        double alone = 0;
        for (std::size_t i = 0; i < output.indices.size(); ++i) {
            const std::string key =
                i < study.uncertain.size() ? std::string(study.uncertain[i].parameter->key) : "draws";
            const SobolIndex& index = output.indices[i];
            alone += index.first.value;
            grid.add({i == 0 ? name : "", key, bar(index),
                      rounded(index.total.value, 3) + " +- " + rounded(index.total.error, 1)});
        }
        constexpr double nearlyAll = 0.9;
        if (alone < nearlyAll) grid.add({"", "acts in combination"});
    }
    return text + grid.text();
}

std::string placeText(const DesignStudy& study, const std::vector<double>& at) {
    std::string text;
    for (std::size_t i = 0; i < at.size(); ++i) {
        text += text.empty() ? "" : ", ";
        if (i < study.uncertain.size()) {
            const Parameter& parameter = *study.uncertain[i].parameter;
            text += std::string(parameter.key) + " " + inHandyUnit(at[i], parameter.quantity, 4);
        } else {
            text += "row " + std::to_string(static_cast<std::size_t>(at[i]) + 1) + " of the draws";
        }
    }
    return text;
}

std::string worstText(const DesignReport& report) {
    std::string text = "\n";
    for (std::size_t a = 0; a < report.findings.worst.size(); ++a) {
        const std::optional<WorstCase>& worst = report.findings.worst[a];
        if (!worst) continue;
        const DesignAim& aim = report.study.aims[a];
        const std::string extreme = aim.sense == Sense::largest ? "Least " : "Largest ";
        text +=
            paragraph(extreme + std::string(aim.output->name) + " of the robust best found in the ranges: " +
                      outputText(report.study, *aim.output, worst->value) + " at " +
                      placeText(report.study, worst->at) +
                      " (samples alone: " + outputText(report.study, *aim.output, worst->sampled) + "; " +
                      std::to_string(worst->searches) + " searches, " + std::to_string(worst->agreeing) +
                      " of them ended here).");
    }
    return text;
}

}  // namespace

std::string designText(const DesignReport& report) {
    std::string text = titleLine(report.study.base) + variedText(report.study) + "\n" + bestText(report) +
                       costText(report) + paretoText(report) + sensitivityText(report) + worstText(report);
    for (const DesignRemark& remark : remarksOn(report)) text += paragraph(remark.text);
    return text;
}

}  // namespace drillwave
