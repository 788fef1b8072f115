// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/design_words.h"

#include <algorithm>
#include <cmath>

#include "core/model/parameter.h"
#include "core/report/alert_words.h"
#include "core/report/parameter_words.h"
#include "core/text/enum_names.h"
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
            ? translatable("%1 sample could not be solved and is left out of the statistics. Reason: %2.")
            : translatable("%1 samples could not be solved and are left out of the statistics. Reason: %2."),
        {std::to_string(unsolved), reason}};
    if (without > 0) {
        const Message more{without == 1 ? translatable("%1 design has no statistics, because more than 0.1 % "
                                                       "of its samples could not be solved.")
                                        : translatable("%1 designs have no statistics, because more than 0.1 "
                                                       "% of their samples could not be solved."),
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
             {translatable("In up to %1 % of the samples of a design, the bit chatters on the rock. The "
                           "numerical error of these blows is larger than the error of the statistics."),
              {style.number(share * 100, 3)}}});
}

/// "100 us or 200 us or 3 others"
Message bestNames(const DesignReport& report, const DesignNames& names) {
    const BestDesigns& best = report.findings.best;
    constexpr std::size_t enough = 6;
    Message list = names.design(*best.robust);
    const std::size_t named = std::min(best.ties.size(), enough);
    for (std::size_t i = 0; i < named; ++i)
        list = {i + 1 < best.ties.size() ? "%1, %2" : translatable("%1 or %2"),
                {list, names.design(best.ties[i])}};
    if (best.ties.size() > enough)
        list = {translatable("%1 or %2 others"), {list, std::to_string(best.ties.size() - enough)}};
    return list;
}

void addTies(const DesignReport& report, const DesignNames& names, std::vector<DesignRemark>& remarks) {
    const BestDesigns& best = report.findings.best;
    if (best.ties.empty()) return;
    const Message list = bestNames(report, names);
    if (!best.nextBest) {
        remarks.push_back(
            {false,
             "flat_optimum",
             {translatable("These designs are equally good within the error: %1. Use any of them."),
              {list}}});
        return;
    }
    const DesignAim& next = report.study.aims[1];
    remarks.push_back(
        {false,
         "flat_optimum",
         {next.sense == Sense::largest
              ? translatable("These designs are equally good within the error: %1. Use any of them. Among "
                             "them, the design %2 has the largest value of %3, %4.")
              : translatable("These designs are equally good within the error: %1. Use any of them. Among "
                             "them, the design %2 has the smallest value of %3, %4."),
          {list, names.design(*best.nextBest), names.aim(next),
           names.value(*next.output, aimedValue(report, next, *best.nextBest).value, 5)}}});
}

/// The place on an axis next to the one that is at an end of its values.
std::uint64_t nextTo(const SweepAxis& axis, std::uint64_t end) {
    std::uint64_t next = end;
    for (std::uint64_t n = 0; n < axis.count; ++n) {
        if (axis.value(n) == axis.value(end)) continue;
        const auto distance = [&](std::uint64_t at) { return std::abs(axis.value(at) - axis.value(end)); };
        if (next == end || distance(n) < distance(next)) next = n;
    }
    return next;
}

/// Only where the end is better than its neighbour by more than the errors.
void addEdges(const DesignReport& report, std::vector<DesignRemark>& remarks) {
    const BestDesigns& best = report.findings.best;
    std::uint64_t rest = *best.robust, stride = 1;
    for (std::size_t i = report.study.choices.size(); i-- > 0;) {
        const SweepAxis& axis = report.study.choices[i];
        const std::uint64_t index = rest % axis.count, step = stride;
        rest /= axis.count;
        stride *= axis.count;
        if (!axis.parameter || axis.count < 2) continue;
        double least = axis.value(0), most = least;
        for (std::uint64_t n = 1; n < axis.count; ++n) {
            least = std::min(least, axis.value(n));
            most = std::max(most, axis.value(n));
        }
        const double value = axis.value(index);
        if ((value != least && value != most) || least == most) continue;
        const std::size_t neighbour = *best.robust - index * step + nextTo(axis, index) * step;
        if (std::ranges::find(best.ties, neighbour) != best.ties.end()) continue;
        if (!makesDifference(report.study, report.findings, i)) continue;
        remarks.push_back({false,
                           "optimum_at_edge",
                           {value == most ? translatable("The best design for uncertain rock lies at the "
                                                         "upper end of the range of %1: extend that range.")
                                          : translatable("The best design for uncertain rock lies at the "
                                                         "lower end of the range of %1: extend that range."),
                            {std::string(axis.key())}}});
    }
}

bool choosesHammers(const DesignStudy& study) {
    return std::ranges::any_of(study.choices, [](const SweepAxis& axis) {
        return axis.presets && axis.presets->part() == PresetPart::hammer;
    });
}

void addEnergy(const DesignReport& report, const ReadingStyle& style, std::vector<DesignRemark>& remarks) {
    constexpr double much = 0.01;
    if (report.study.keepsEnergy || report.findings.energySpread <= much) return;
    if (choosesHammers(report.study)) {
        remarks.push_back({false,
                           "energy_varies",
                           {translatable("The blow energy differs by up to %1 % between the designs: hammers "
                                         "of different power are compared."),
                            {style.number(report.findings.energySpread * 100, 3)}}});
        return;
    }
    remarks.push_back(
        {true,
         "energy_varies",
         {translatable("The blow energy differs by up to %1 % between the designs: machines of different "
                       "power are compared. Use --keep-energy to compare at the same energy."),
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
            remarks.push_back({false, "gamma_dominates",
                               translatable("Nearly all scatter of the efficiency comes from the elasticity "
                                            "gamma of the rock. To compare hammers, choose the loading work "
                                            "as the objective: --aim max:loading_work@q05.")});
        }
    }
}

/// The first aim in which the design to take differs from the present one by more than the errors.
const DesignAim& decidingAim(const DesignReport& report, std::size_t present) {
    for (const DesignAim& aim : report.study.aims) {
        const SampledValue& chosen = aimedValue(report, aim, *report.findings.best.chosen);
        const SampledValue& now = aimedValue(report, aim, present);
        if (chosen.value != now.value && !areEqualWithinErrors(chosen, now)) return aim;
    }
    return report.study.aims.front();
}

Message noDifferenceMessage(const DesignReport& report, const DesignNames& names) {
    const DesignAim& aim = report.study.aims.front();
    const SampledValue& chosen = aimedValue(report, aim, *report.findings.best.chosen);
    double apart = 0;
    for (std::size_t d = 0; d < report.findings.designs.size(); ++d) {
        const SampledValue& value = aimedValue(report, aim, d);
        apart = std::max({apart, std::abs(value.value - chosen.value),
                          aim.statistic.hasError() ? errorOfDifference(value, chosen) : 0.0});
    }
    std::vector<Message> values{names.aim(aim), names.value(*aim.output, chosen.value, 5),
                                names.value(*aim.output, apart, 1),
                                std::to_string(report.findings.designs.size())};
    const std::vector<SweepAxis>& choices = report.study.choices;
    if (choices.size() != 1)
        return {translatable("The choice of the design makes no difference: the objective %1 is %2, within "
                             "%3, for all %4 designs."),
                std::move(values)};
    values.insert(values.begin(), names.choice(choices.front()));
    return {
        translatable(
            "The choice of %1 makes no difference: the objective %2 is %3, within %4, for all %5 designs."),
        std::move(values)};
}

/// Which of several choices make no difference, a sentence each.
Message withoutEffect(const DesignReport& report, Message answer, const DesignNames& names) {
    const std::vector<SweepAxis>& choices = report.study.choices;
    if (choices.size() < 2 || headlineOf(report) == DesignHeadline::noDifference || answer.isEmpty())
        return answer;
    for (std::size_t i = 0; i < choices.size(); ++i)
        if (choices[i].count > 1 && !makesDifference(report.study, report.findings, i))
            answer = {
                "%1 %2",
                {std::move(answer),
                 Message(translatable("The choice of %1 makes no difference to the objectives and limits."),
                         {names.choice(choices[i])})}};
    return answer;
}

/// Returns the parameter that is chosen, if it is the only choice: its values alone do not say what they are.
const SweepAxis* onlyParameter(const DesignStudy& study) {
    return study.choices.size() == 1 && study.choices.front().parameter ? &study.choices.front() : nullptr;
}

/// "pulse.duration = 200 us", "200 us, 3.05 m", "medium drifter"
Message designWithName(const DesignReport& report, std::size_t design, const DesignNames& names) {
    const SweepAxis* only = onlyParameter(report.study);
    if (!only) return names.design(design);
    return {"%1 = %2", {names.choice(*only), names.design(design)}};
}

/// The headline without what speaks against the design.
Message answerMessage(const DesignReport& report, const DesignNames& names) {
    const std::optional<DesignHeadline> headline = headlineOf(report);
    if (!headline || *headline == DesignHeadline::noneFeasible) return {};
    if (*headline == DesignHeadline::noDifference) return noDifferenceMessage(report, names);
    const std::optional<std::size_t> present = presentDesign(report.study);
    const DesignAim& first = report.study.aims.front();
    if (*headline == DesignHeadline::keep)
        return {
            translatable("Keep the present design, %1: none of the %2 designs compared is better (%3 = %4)."),
            {designWithName(report, *present, names), std::to_string(report.findings.designs.size()),
             names.aim(first), names.aimed(report, first, *present)}};
    const std::size_t chosen = *report.findings.best.chosen;
    const std::string name = names.design(chosen);
    if (!present || std::isnan(aimedValue(report, first, *present).value))
        return {
            translatable("Choose the design %1, which gives %2 = %3."),
            {designWithName(report, chosen, names), names.aim(first), names.aimed(report, first, chosen)}};
    const SweepAxis* only = onlyParameter(report.study);
    if (!report.findings.feasibility[*present].feasible && only)
        return {
            translatable(
                "Change %1 from %2 to %3, which gives %4 = %5. The present design does not meet all limits."),
            {names.choice(*only), names.design(*present), name, names.aim(first),
             names.aimed(report, first, chosen)}};
    if (!report.findings.feasibility[*present].feasible)
        return {translatable("Change the design from %1 to %2, which gives %3 = %4. The present design does "
                             "not meet all limits."),
                {names.design(*present), name, names.aim(first), names.aimed(report, first, chosen)}};
    const DesignAim& deciding = decidingAim(report, *present);
    if (only)
        return {translatable("Change %1 from %2 to %3: this improves %4 from %6 to %5."),
                {names.choice(*only), names.design(*present), name, names.aim(deciding),
                 names.aimed(report, deciding, chosen), names.aimed(report, deciding, *present)}};
    return {translatable("Change the design from %1 to %2: this improves %3 from %5 to %4."),
            {names.design(*present), name, names.aim(deciding), names.aimed(report, deciding, chosen),
             names.aimed(report, deciding, *present)}};
}

}  // namespace

Message designWarning(const DesignReport& report, const DesignNames& names) {
    const std::vector<Alert>& alerts = report.findings.alerts;
    if (alerts.empty()) return {};
    Message text = alertMessage(alerts.front(), names.style());
    Message warning = report.study.choices.empty()
                          ? Message(translatable("Warning: %1"), {std::move(text)})
                          : Message(translatable("Warning for %1: %2"),
                                    {names.design(*report.findings.recommended), std::move(text)});
    if (alerts.size() > 1)
        warning = {"%1 %2",
                   {std::move(warning),
                    {translatable("Number of other warnings for this design: %1."),
                     {std::to_string(alerts.size() - 1)}}}};
    return warning;
}

std::string DesignNames::design(std::uint64_t design) const {
    std::string text;
    const std::vector<double> values = m_study.choice(design);
    for (std::size_t i = 0; i < values.size(); ++i)
        text += (text.empty() ? "" : ", ") + choiceValue(m_study.choices[i], values[i]);
    return text.empty() ? "FILE" : text;
}

std::string DesignNames::choiceValue(const SweepAxis& choice, double value) const {
    if (choice.parameter) return m_style.quantity(value, choice.parameter->quantity);
    std::string text;
    choice.column().appendText(text, value);
    return text;
}

Message DesignNames::aim(const DesignAim& aim) const {
    return aimedName(aim);
}

Message DesignNames::choice(const SweepAxis& choice) const {
    return choice.parameter ? fieldMessage(*choice.parameter, m_style) : Message(std::string(choice.key()));
}

std::string DesignNames::value(const Output& output, double value, int digits) const {
    return outputText(m_study, output, value, m_style, digits);
}

std::string DesignNames::aimed(const DesignReport& report, const DesignAim& aim, std::size_t design) const {
    return aimedWithError(report, aim, design, m_style);
}

std::string_view name(DesignHeadline headline) {
    static constexpr EnumNames<DesignHeadline> names{{{DesignHeadline::keep, "keep"},
                                                      {DesignHeadline::change, "change"},
                                                      {DesignHeadline::noDifference, "no_difference"},
                                                      {DesignHeadline::noneFeasible, "none_feasible"}}};
    return names[headline];
}

std::optional<DesignHeadline> headlineOf(const DesignReport& report) {
    const BestDesigns& best = report.findings.best;
    if (report.findings.designs.size() < 2) return {};
    if (!best.chosen) return DesignHeadline::noneFeasible;
    if (best.equal.size() == report.findings.designs.size()) return DesignHeadline::noDifference;
    const std::optional<std::size_t> present = presentDesign(report.study);
    return present && std::ranges::find(best.equal, *present) != best.equal.end() ? DesignHeadline::keep
                                                                                  : DesignHeadline::change;
}

Message designAnswerMessage(const DesignReport& report, const DesignNames& names) {
    return withoutEffect(report, answerMessage(report, names), names);
}

Message headlineMessage(const DesignReport& report, const DesignNames& names) {
    Message answer = designAnswerMessage(report, names);
    Message warning = designWarning(report, names);
    if (answer.isEmpty() || warning.isEmpty()) return answer.isEmpty() ? warning : answer;
    return Message("%1 %2", {std::move(answer), std::move(warning)});
}

Message headlineMessage(const DesignReport& report, const ReadingStyle& style) {
    return headlineMessage(report, DesignNames(report.study, style));
}

std::vector<std::string_view> marksOf(const DesignReport& report, std::size_t design,
                                      std::optional<std::size_t> present) {
    const BestDesigns& best = report.findings.best;
    std::vector<std::string_view> marks;
    if (best.robust == design) marks.emplace_back("best_uncertain");
    if (best.nominal == design) marks.emplace_back("best_nominal");
    if (best.equal.size() > 1 && std::ranges::find(best.equal, design) != best.equal.end())
        marks.emplace_back("equal");
    if (present == design) marks.emplace_back("present");
    return marks;
}

std::vector<DesignRemark> remarksOn(const DesignReport& report, const DesignNames& names) {
    std::vector<DesignRemark> remarks;
    addUnsolved(report, remarks);
    addUncertain(report, names.style(), remarks);
    addTies(report, names, remarks);
    addEdges(report, remarks);
    addEnergy(report, names.style(), remarks);
    addGamma(report, remarks);
    return remarks;
}

std::vector<DesignRemark> remarksOn(const DesignReport& report, const ReadingStyle& style) {
    return remarksOn(report, DesignNames(report.study, style));
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

std::string aimedWithError(const DesignReport& report, const DesignAim& aim, std::size_t design,
                           const ReadingStyle& style) {
    const SampledValue& value = aimedValue(report, aim, design);
    std::string text = outputText(report.study, *aim.output, value.value, style);
    if (aim.statistic.hasError() && !std::isnan(value.value))
        text += " +- " + outputText(report.study, *aim.output, value.error(), style, 1);
    return text;
}

Message statisticMessage(const Statistic& statistic, Sense sense) {
    switch (statistic.kind) {
        case Statistic::Kind::mean:
            return translatable("on average");
        case Statistic::Kind::least:
            return translatable("in the smallest sample");
        case Statistic::Kind::largest:
            return translatable("in the largest sample");
        case Statistic::Kind::nominal:
            return translatable("for the values entered");
        case Statistic::Kind::quantile:
            break;
    }
    if (statistic.percent == 50) return translatable("in the middle (median)");
    if (sense == Sense::largest)
        return {translatable("reached in %1 % of cases"), {std::to_string(100 - statistic.percent)}};
    return {translatable("not exceeded in %1 % of cases"), {std::to_string(statistic.percent)}};
}

std::string aimedName(const DesignAim& aim) {
    return std::string(aim.output->name) + " " + aim.statistic.name();
}

std::string designName(const DesignStudy& study, std::uint64_t design, const ReadingStyle& style) {
    return DesignNames(study, style).design(design);
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
            lines.push_back(about(option, translatable("no design reaches it")));
        else
            lines.push_back(about(option, {translatable("the nearest is %1 of %2"),
                                           {outputText(study, *limit.output, best, style),
                                            designName(study, nearest, style)}}));
    }
    return lines;
}

}  // namespace drillwave
