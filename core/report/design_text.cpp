// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/design_report.h"

#include <algorithm>
#include <cmath>

#include "core/model/parameter.h"
#include "core/report/design_words.h"
#include "core/report/report_table.h"
#include "core/report/report_text.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

std::string rangeText(const UncertainInput& input, const ReadingStyle& style) {
    const std::string key(input.parameter->key);
    if (input.kind == DistributionKind::percent) return key + " +-" + style.number(input.percent) + " %";
    const Quantity quantity = input.parameter->quantity;
    return key + " " + style.quantity(input.low, quantity) + " ... " + style.quantity(input.high, quantity) +
           (input.kind == DistributionKind::uniform ? "" : " " + std::string(name(input.kind)));
}

Message uncertainMessage(const DesignStudy& study, const ReadingStyle& style) {
    std::string list;
    const auto add = [&](const std::string& text) { list += (list.empty() ? "" : ", ") + text; };
    for (const UncertainInput& input : study.uncertain) add(rangeText(input, style));
    if (study.draws) {
        std::string keys;
        for (const KeptParameter& parameter : study.draws->parameters)
            keys += (keys.empty() ? "" : " ") + std::string(parameter->key);
        add(style.said({translatable("%1 draws of %2"), {std::to_string(study.draws->rows()), keys}}));
    }
    return {translatable("Uncertain: %1."), {list}};
}

Message chosenMessage(const DesignStudy& study, const ReadingStyle& style) {
    Message list;
    for (const SweepAxis& axis : study.choices) {
        list =
            joined(std::move(list), "%1, %2",
                   {translatable("%1 (%2 values)"), {std::string(axis.key()), std::to_string(axis.count)}});
    }
    if (list.isEmpty())
        list = style.isPrinted() ? translatable("nothing, only the present design")
                                 : translatable("nothing, only the design of FILE");
    if (study.keepsEnergy && style.isPrinted())
        return {translatable("Design variables: %1. All blows have the energy of the present one."), {list}};
    return {study.keepsEnergy ? translatable("Design variables: %1; every blow has the energy of FILE.")
                              : translatable("Design variables: %1."),
            {list}};
}

Message samplesMessage(const DesignStudy& study) {
    const std::uint64_t designs = study.designCount();
    return {designs == 1
                ? translatable("%1 design with %2 samples; +- is the 95 % error.")
                : translatable("%1 designs with %2 samples each, the same for all; +- is the 95 % error."),
            {std::to_string(designs), std::to_string(study.samples)}};
}

std::string aimWords(const DesignAim& aim) {
    return (aim.sense == Sense::largest ? "max " : "min ") + aimedName(aim);
}

/// The best designs with what they come to.
class DesignTable {
  public:
    DesignTable(const DesignReport& report, const std::string& first, const ReadingStyle& style)
        : m_report(report), m_style(style) {
        std::vector<std::string> titles{first, style.said(translatable("design"))};
        for (const DesignAim& aim : report.study.aims) {
            titles.push_back(style.said({translatable("%1 nominal"), {std::string(aim.output->name)}}));
            titles.push_back(aimWords(aim));
        }
        m_grid.add(titles);
    }

    void add(const std::string& title, std::size_t design) {
        const DesignStudy& study = m_report.study;
        std::vector<std::string> cells{title, designName(study, design, m_style)};
        for (const DesignAim& aim : study.aims) {
            const std::size_t output = study.placeOf(*aim.output, {}).output;
            cells.push_back(
                outputText(study, *aim.output, m_report.findings.designs[design].nominal[output], m_style));
            cells.push_back(aimedWithError(m_report, aim, design, m_style));
        }
        if (m_report.findings.feasibility[design].marginal)
            cells.push_back(m_style.said(translatable("marginal")));
        m_grid.add(cells);
    }

    const TextGrid& grid() const { return m_grid; }
    std::string text() const { return m_grid.text(); }

  private:
    const DesignReport& m_report;
    const ReadingStyle& m_style;
    TextGrid m_grid;
};

std::string bestText(const DesignReport& report, const ReadingStyle& style) {
    const BestDesigns& best = report.findings.best;
    DesignTable table(report, "", style);
    table.add(style.said(translatable("best for uncertain rock")), *best.robust);
    if (best.nominal) table.add(style.said(translatable("best for the values entered")), *best.nominal);
    if (const auto file = presentDesign(report.study); file && report.study.designCount() > 1)
        table.add(style.said(translatable("present design")), *file);
    return table.text();
}

/// Returns what the robust best costs where all is as in the file, and what it brings; empty if the nominal
/// best is the same.
Message costMessage(const DesignReport& report, const ReadingStyle& style) {
    const BestDesigns& best = report.findings.best;
    if (!best.nominal || *best.nominal == *best.robust) return {};
    const DesignAim& aim = report.study.aims.front();
    const std::size_t output = report.study.placeOf(*aim.output, {}).output;
    const auto nominal = [&](std::size_t d) { return report.findings.designs[d].nominal[output]; };
    const double brings =
        aimedValue(report, aim, *best.robust).value - aimedValue(report, aim, *best.nominal).value;
    const double costs = nominal(*best.robust) - nominal(*best.nominal);
    const auto change = [&](double difference) {
        return (difference > 0 ? "+" : "") + outputText(report.study, *aim.output, difference, style, 3);
    };
    return {style.isPrinted() ? translatable("%1 instead of %2: %3 %4, with the values entered %5.")
                              : translatable("%1 instead of %2: %3 %4, with the values of FILE %5."),
            {designName(report.study, *best.robust, style), designName(report.study, *best.nominal, style),
             aimedName(aim), change(brings), change(costs)}};
}

std::string paretoText(const DesignReport& report, const ReadingStyle& style) {
    if (report.study.aims.size() < 2 || report.study.designCount() < 2) return {};
    DesignTable table(report, style.said(translatable("no design is better in all aims")), style);
    constexpr std::size_t enough = 12;
    std::size_t told = 0, all = 0;
    for (std::size_t d = 0; d < report.findings.designs.size(); ++d) {
        if (!report.findings.best.pareto[d]) continue;
        ++all;
        if (told++ < enough) table.add(std::to_string(d + 1), d);
    }
    std::string text = "\n" + table.text();
    if (all > enough)
        text += paragraph(style.said(
            {translatable("and %1 more: -o DIR writes them all."), {std::to_string(all - enough)}}));
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

void addOutput(const DesignReport& report, std::size_t o, const ReadingStyle& style, TextGrid& grid) {
    const DesignStudy& study = report.study;
    const OutputSensitivity& output = report.findings.sensitivity.outputs[o];
    const std::string name(report.findings.aimed[o]->name);
    if (output.isConstant) {
        grid.add({name, style.said(translatable("constant"))});
        return;
    }
    double alone = 0;
    for (std::size_t i = 0; i < output.indices.size(); ++i) {
        const std::string key = i < study.uncertain.size() ? std::string(study.uncertain[i].parameter->key)
                                                           : style.said(translatable("draws"));
        const SobolIndex& index = output.indices[i];
        alone += index.first.value;
        grid.add({i == 0 ? name : "", key, bar(index),
                  style.number(index.total.value, 3) + " +- " + style.number(index.total.error, 1)});
    }
    constexpr double nearlyAll = 0.9;
    if (alone < nearlyAll) grid.add({"", style.said(translatable("acts with others"))});
}

std::string sensitivityText(const DesignReport& report, const ReadingStyle& style) {
    if (report.study.dimensions() < 2) return {};
    TextGrid grid(CellAlignment::left);
    for (std::size_t o = 0; o < report.findings.sensitivity.outputs.size(); ++o)
        addOutput(report, o, style, grid);
    return "\n" +
           style.said(translatable("Worth measuring: share of the scatter, # by itself, - with others")) +
           "\n" + grid.text();
}

std::string placeText(const DesignStudy& study, const std::vector<double>& at, const ReadingStyle& style) {
    std::string text;
    for (std::size_t i = 0; i < at.size(); ++i) {
        text += text.empty() ? "" : ", ";
        if (i < study.uncertain.size()) {
            const Parameter& parameter = *study.uncertain[i].parameter;
            text += std::string(parameter.key) + " " + style.quantity(at[i], parameter.quantity, 4);
        } else {
            text += style.said(
                {translatable("row %1 of the draws"), {std::to_string(static_cast<std::size_t>(at[i]) + 1)}});
        }
    }
    return text;
}

Message worstMessage(const DesignReport& report, std::size_t a, const ReadingStyle& style) {
    const WorstCase& worst = *report.findings.worst[a];
    const DesignAim& aim = report.study.aims[a];
    return {aim.sense == Sense::largest
                ? translatable("Smallest %1 of the best design within the ranges: %2 at %3 (samples only: "
                               "%4; %5 searches, %6 of them ended here).")
                : translatable("Largest %1 of the best design within the ranges: %2 at %3 (samples only: %4; "
                               "%5 searches, %6 of them ended here)."),
            {std::string(aim.output->name), outputText(report.study, *aim.output, worst.value, style),
             placeText(report.study, worst.at, style),
             outputText(report.study, *aim.output, worst.sampled, style), std::to_string(worst.searches),
             std::to_string(worst.agreeing)}};
}

/// Returns worst cases, then remarks.
std::vector<Message> closingSentences(const DesignReport& report, const ReadingStyle& style) {
    std::vector<Message> sentences;
    for (std::size_t a = 0; a < report.findings.worst.size(); ++a)
        if (report.findings.worst[a]) sentences.push_back(worstMessage(report, a, style));
    for (DesignRemark& remark : remarksOn(report, style)) sentences.push_back(std::move(remark.text));
    return sentences;
}

/// Returns a mark of marksOf() in words.
const char* markWords(std::string_view mark) {
    if (mark == "best_uncertain") return translatable("best for uncertain rock");
    if (mark == "best_nominal") return translatable("best for the values entered");
    return mark == "equal" ? translatable("equally good") : translatable("present design");
}

}  // namespace

std::vector<Message> designQuestionSentences(const DesignReport& report, const ReadingStyle& style) {
    return {uncertainMessage(report.study, style), chosenMessage(report.study, style),
            samplesMessage(report.study)};
}

std::vector<Message> designAnswerSentences(const DesignReport& report, const ReadingStyle& style) {
    std::vector<Message> sentences;
    if (Message cost = costMessage(report, style); !cost.isEmpty()) sentences.push_back(std::move(cost));
    append(sentences, closingSentences(report, style));
    return sentences;
}

TextGrid designsGrid(const DesignReport& report, const ReadingStyle& style) {
    const std::optional<std::size_t> present = presentDesign(report.study);
    const std::size_t count = report.findings.designs.size();
    DesignTable table(report, "", style);
    for (std::size_t d = 0; d < count; ++d) {
        std::string marks;
        for (const std::string_view mark : marksOf(report, d, present))
            marks += (marks.empty() ? "" : ", ") + style.said(markWords(mark));
        if (count <= mostShownDesigns || !marks.empty()) table.add(marks, d);
    }
    return table.grid();
}

std::string designText(const DesignReport& report, const ReadingStyle& style) {
    std::string text = titleLine(report.study.base);
    const auto add = [&](const Message& message) {
        if (!message.isEmpty()) text += paragraph(style.said(message));
    };
    add(headlineMessage(report, style));
    for (const Message& sentence : designQuestionSentences(report, style)) add(sentence);
    constexpr std::size_t fewDesigns = 10;
    const std::size_t count = report.study.designCount();
    text += "\n" +
            (count > 1 && count <= fewDesigns ? designsGrid(report, style).text() : bestText(report, style));
    add(costMessage(report, style));
    text += paretoText(report, style) + sensitivityText(report, style) + "\n";
    for (const Message& sentence : closingSentences(report, style)) add(sentence);
    return text;
}

}  // namespace drillwave
