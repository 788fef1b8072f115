// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/design_words.h"

#include <algorithm>
#include <cmath>

#include "core/model/parameter.h"
#include "core/text/handy_text.h"

namespace drillwave {

namespace {

void addUnsolved(const DesignReport& report, std::vector<DesignRemark>& remarks) {
    std::uint64_t unsolved = report.findings.sensitivity.unsolved;
    std::size_t without = 0;
    Message reason = report.findings.sensitivity.reason;
    for (const DesignSamples& design : report.findings.designs) {
        unsolved += design.unsolved;
        without += !design.hasStatistics(report.study.samples);
        if (reason.isEmpty()) reason = design.reason;
    }
    if (unsolved == 0) return;
    Message text{
        unsolved == 1
            ? translatable("drillwave::Message", "%1 sample could not be solved and are left out: %2.")
            : translatable("drillwave::Message", "%1 samples could not be solved and are left out: %2."),
        {std::to_string(unsolved), reason}};
    if (without > 0) {
        const Message more{without == 1
                               ? translatable("drillwave::Message",
                                              "%1 design with more than 0.1 % of them have no statistics.")
                               : translatable("drillwave::Message",
                                              "%1 designs with more than 0.1 % of them have no statistics."),
                           {std::to_string(without)}};
        text = {"%1 %2", {text, more}};
    }
    remarks.push_back({without > 0, "points_unsolved", text});
}

void addUncertain(const DesignReport& report, const ReadingStyle& style, std::vector<DesignRemark>& remarks) {
    double share = 0;
    for (const DesignSamples& design : report.findings.designs)
        share = std::max(share, design.uncertainShare);
    if (share > 0)
        remarks.push_back(
            {false,
             "points_uncertain",
             {translatable("drillwave::Message",
                           "Up to %1 % of the samples of a design have an error of their own that is larger "
                           "than that of the statistics: blows that chatter."),
              {style.number(share * 100, 2)}}});
}

/// "100 us or 200 us or 3 others"
Message bestNames(const DesignReport& report, const ReadingStyle& style) {
    const BestDesigns& best = report.findings.best;
    constexpr std::size_t enough = 6;
    Message names = designName(report.study, *best.robust, style);
    for (std::size_t i = 0; i < best.ties.size() && i < enough; ++i)
        names = {translatable("drillwave::Message", "%1 or %2"),
                 {names, designName(report.study, best.ties[i], style)}};
    if (best.ties.size() > enough)
        names = {translatable("drillwave::Message", "%1 or %2 others"),
                 {names, std::to_string(best.ties.size() - enough)}};
    return names;
}

void addTies(const DesignReport& report, const ReadingStyle& style, std::vector<DesignRemark>& remarks) {
    const BestDesigns& best = report.findings.best;
    if (best.ties.empty()) return;
    const Message names = bestNames(report, style);
    if (!best.nextBest) {
        remarks.push_back({false,
                           "flat_optimum",
                           {translatable("drillwave::Message",
                                         "The samples do not tell the best designs apart: take any of %1."),
                            {names}}});
        return;
    }
    const DesignAim& next = report.study.aims[1];
    remarks.push_back(
        {false,
         "flat_optimum",
         {next.sense == Sense::largest
              ? translatable("drillwave::Message",
                             "The samples do not tell the best designs apart: take any of %1; of them %2 "
                             "has the largest %3, %4.")
              : translatable("drillwave::Message",
                             "The samples do not tell the best designs apart: take any of %1; of them %2 "
                             "has the least %3, %4."),
          {names, designName(report.study, *best.nextBest, style), aimedName(next),
           outputText(report.study, *next.output, aimedValue(report, next, *best.nextBest).value, style)}}});
}

void addEdges(const DesignReport& report, std::vector<DesignRemark>& remarks) {
    std::uint64_t rest = *report.findings.best.robust;
    for (std::size_t i = report.study.choices.size(); i-- > 0;) {
        const SweepAxis& axis = report.study.choices[i];
        const std::uint64_t index = rest % axis.count;
        rest /= axis.count;
        if (!axis.parameter || axis.count < 2) continue;
        double least = axis.value(0), most = least;
        for (std::uint64_t n = 1; n < axis.count; ++n) {
            least = std::min(least, axis.value(n));
            most = std::max(most, axis.value(n));
        }
        const double value = axis.value(index);
        if (value != least && value != most) continue;
        remarks.push_back(
            {false,
             "optimum_at_edge",
             {value == most ? translatable("drillwave::Message",
                                           "The robust best is at the upper end of %1: widen the choice.")
                            : translatable("drillwave::Message",
                                           "The robust best is at the lower end of %1: widen the choice."),
              {std::string(axis.key())}}});
    }
}

void addEnergy(const DesignReport& report, const ReadingStyle& style, std::vector<DesignRemark>& remarks) {
    constexpr double much = 0.01;
    if (report.study.keepsEnergy || report.findings.energySpread <= much) return;
    remarks.push_back({true,
                       "energy_varies",
                       {translatable("drillwave::Message",
                                     "The choices change the energy of the blow by up to %1 %: machines of "
                                     "different power are compared; --keep-energy keeps it."),
                        {style.number(report.findings.energySpread * 100, 3)}}});
}

void addGamma(const DesignReport& report, std::vector<DesignRemark>& remarks) {
    constexpr double nearlyAll = 0.9;
    if (!carriesShares(report.study)) return;
    const Sensitivity& sensitivity = report.findings.sensitivity;
    if (report.study.dimensions() < 2) return;
    for (std::size_t o = 0; o < sensitivity.outputs.size(); ++o) {
        if (report.findings.aimed[o]->name != "efficiency" || sensitivity.outputs[o].isConstant) continue;
        for (std::size_t i = 0; i < report.study.uncertain.size(); ++i) {
            const std::string_view key = report.study.uncertain[i].parameter->key;
            if ((key != "bit_rock.gamma" && key != "gamma") ||
                sensitivity.outputs[o].indices[i].total.value <= nearlyAll)
                continue;
            remarks.push_back(
                {false, "gamma_dominates",
                 translatable("drillwave::Message",
                              "The scatter of the efficiency is nearly all that of gamma; loading_work "
                              "shows what wave and machine can do: --aim max:loading_work@q05.")});
        }
    }
}

}  // namespace

std::vector<DesignRemark> remarksOn(const DesignReport& report, const ReadingStyle& style) {
    std::vector<DesignRemark> remarks;
    addUnsolved(report, remarks);
    addUncertain(report, style, remarks);
    addTies(report, style, remarks);
    addEdges(report, remarks);
    addEnergy(report, style, remarks);
    addGamma(report, remarks);
    return remarks;
}

// Each replicate has a variance of its own, which of two or three points may be anything.
bool carriesShares(const DesignStudy& study) {
    return study.samples >= leastDesignSamples;
}

std::optional<std::size_t> firstToMeasure(const DesignReport& report, std::size_t aimed) {
    constexpr double mostErrorOfShare = 1.0 / 3;  // so that it is there, and its order of magnitude
    const OutputSensitivity& output = report.findings.sensitivity.outputs[aimed];
    if (output.isConstant || output.indices.empty()) return {};
    if (report.study.dimensions() < 2 || !carriesShares(report.study)) return {};
    const auto most = std::ranges::max_element(output.indices, {},
                                               [](const SobolIndex& index) { return index.total.value; });
    if (!(most->total.error < mostErrorOfShare * most->total.value)) return {};
    return static_cast<std::size_t>(most - output.indices.begin());
}

const SampledValue& aimedValue(const DesignReport& report, const DesignAim& aim, std::size_t design) {
    const StatisticPlace place = report.study.placeOf(*aim.output, aim.statistic);
    return report.findings.designs[design].statistics[place.output][place.statistic];
}

std::string aimedName(const DesignAim& aim) {
    return std::string(aim.output->name) + " " + aim.statistic.name();
}

std::string designName(const DesignStudy& study, std::uint64_t design, const ReadingStyle& style) {
    std::string text;
    const std::vector<double> values = study.choice(design);
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += text.empty() ? "" : ", ";
        const SweepAxis& axis = study.choices[i];
        if (axis.parameter)
            text += style.quantity(values[i], axis.parameter->quantity);
        else
            axis.column().appendText(text, values[i]);
    }
    return text.empty() ? "FILE" : text;
}

std::string outputText(const DesignStudy& study, const Output& output, double value,
                       const ReadingStyle& style, int digits) {
    if (std::isnan(value)) return "-";
    const bool inUnit = hasUnits(study.base) || output.isOnlySi();
    return style.quantity(value, inUnit ? output.quantity() : Quantity::ratio, digits);
}

std::vector<Message> nearestToLimits(const DesignStudy& study, const DesignFindings& findings,
                                     const ReadingStyle& style) {
    std::vector<Message> lines;
    for (const DesignLimit& limit : study.limits) {
        const StatisticPlace place = study.placeOf(*limit.output, limit.statistic);
        std::size_t nearest = 0;
        double best = NAN;
        for (std::size_t d = 0; d < findings.designs.size(); ++d) {
            const double value = findings.designs[d].statistics[place.output][place.statistic].value;
            if (std::isnan(value) || (limit.atMost ? value >= best : value <= best)) continue;
            best = value;
            nearest = d;
        }
        const std::string option = std::string(limit.atMost ? "--at-most " : "--at-least ") + limit.name() +
                                   "=" + outputText(study, *limit.output, limit.bound);  // as it is typed
        if (std::isnan(best))
            lines.push_back(about(option, translatable("drillwave::Message", "no design has it")));
        else
            lines.push_back(about(option, {translatable("drillwave::Message", "the nearest is %1 of %2"),
                                           {outputText(study, *limit.output, best, style),
                                            designName(study, nearest, style)}}));
    }
    return lines;
}

}  // namespace drillwave
