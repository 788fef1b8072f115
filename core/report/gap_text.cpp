// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/gap_report.h"

#include <algorithm>

#include "core/model/scales.h"
#include "core/report/report_text.h"
#include "core/text/printed_text.h"

namespace drillwave {

namespace {

constexpr int gapDigits = 6;
constexpr double negligible = 1e-10;  // what the efficiency is known to: elastic rock keeps nothing

/// The columns of the table: e, impulse, peak force, efficiency, each with how it is shown.
class GapTable {
  public:
    GapTable(const Scenario& scenario, const ReadingStyle& style)
        : m_dimensional(hasUnits(scenario)), m_scales(scalesOf(scenario)), m_style(style) {}

    std::string gap(double value) const {
        return m_dimensional ? m_style.quantity(value * m_scales.penetration, Quantity::length, gapDigits)
                             : m_style.number(value, gapDigits);
    }

    void addHeading(const Message& title) {
        const auto over = [&](const char* output, const char* scale) {
            const std::string multiple = m_style.isPrinted() ? printedWords(scale) : scale;
            return m_style.said(output) + (m_dimensional ? "" : multiple);
        };
        m_grid.add({m_style.said(title), "e", over(translatable("impulse"), "/I0"),
                    over(translatable("peak force"), "/F0"), m_style.said(translatable("efficiency"))});
    }

    /// One line of `value(output)`.
    template <class Value>
    void add(const Message& label, const Value& value) {
        const double impulse = 1 + value(GapOutput::cor), force = value(GapOutput::peakForce);
        const double efficiency = value(GapOutput::efficiency);
        m_grid.add({m_style.said(label), m_style.number(value(GapOutput::cor), gapDigits),
                    m_dimensional ? m_style.quantity(impulse * m_scales.impulse, Quantity::impulse, gapDigits)
                                  : m_style.number(impulse, gapDigits),
                    m_dimensional ? m_style.quantity(force * m_scales.force, Quantity::force, gapDigits)
                                  : m_style.number(force, gapDigits),
                    m_style.number(efficiency > negligible ? efficiency : 0, gapDigits)});
    }

    /// Where the extremes lie.
    template <class Extreme>
    void addGaps(const Extreme& extreme) {
        const auto place = [&](GapOutput output) {
            const GapExtreme& found = extreme(output);
            if (found.kind == GapExtreme::Kind::everywhere) return m_style.said(translatable("anywhere"));
            const std::string gap = this->gap(found.gap.value);
            if (found.kind != GapExtreme::Kind::kink) return gap;
            return m_style.said({translatable("%1 kink"), {gap}});
        };
        const std::string cor = place(GapOutput::cor);
        m_grid.add({"  " + m_style.said(translatable("at a gap of")), cor, cor, place(GapOutput::peakForce),
                    place(GapOutput::efficiency)});
    }

    void addBlankLine() { m_grid.add({""}); }
    const TextGrid& grid() const { return m_grid; }

  private:
    bool m_dimensional;
    Scales m_scales;
    const ReadingStyle& m_style;
    TextGrid m_grid;
};

Message quantileLabel(std::size_t i, const ReadingStyle& style) {
    if (gapQuantiles[i] == 0.5) return translatable("median");
    return {translatable("%1 % quantile"), {style.number(gapQuantiles[i] * 100, 3)}};
}

template <class SpreadOf>
void addSpread(GapTable& table, const SpreadOf& spread, const ReadingStyle& style) {
    table.add(translatable("mean"), [&](GapOutput output) { return spread(output).mean.value; });
    for (std::size_t i = 0; i < gapQuantiles.size(); ++i)
        table.add(quantileLabel(i, style),
                  [&](GapOutput output) { return spread(output).quantiles[i].value; });
}

void fill(GapTable& table, const GapStudy& study, const ReadingStyle& style) {
    const GapStatistics& statistics = study.statistics;
    table.addHeading(translatable("all gaps equally likely"));
    table.add(translatable("smallest"),
              [&](GapOutput output) { return statistics.of(output).least.value.value; });
    table.addGaps([&](GapOutput output) -> const GapExtreme& { return statistics.of(output).least; });
    table.add(translatable("largest"),
              [&](GapOutput output) { return statistics.of(output).largest.value.value; });
    table.addGaps([&](GapOutput output) -> const GapExtreme& { return statistics.of(output).largest; });
    addSpread(
        table, [&](GapOutput output) -> const GapSpread& { return statistics.of(output).uniform; }, style);
    if (study.normal) {
        table.addBlankLine();
        table.addHeading({translatable("gap %1 +- %2"),
                          {table.gap(study.normal->mean), table.gap(study.normal->deviation)}});
        addSpread(
            table, [&](GapOutput output) -> const GapSpread& { return *statistics.of(output).normal; },
            style);
    }
}

std::string shareOfGaps(double share, const ReadingStyle& style) {
    return style.number(share * 100, 5) + " %";
}

std::string superRebounds(const GapStudy& study, const GapTable& table, const ReadingStyle& style) {
    const GapStatistics& statistics = study.statistics;
    std::string text = style.said(
        {translatable("e > 1 at %1 of all gaps"), {shareOfGaps(statistics.shareAboveOne.value, style)}});
    if (study.normal)
        text += style.said({translatable(", %1 of the scattered ones"),
                            {shareOfGaps(statistics.normalShareAboveOne->value, style)}});
    for (const GapCrossing& crossing : statistics.crossings)
        text += (&crossing == &statistics.crossings.front() ? ": " : ", ") +
                style.said({crossing.rising ? translatable("rises above 1 at %1")
                                            : translatable("falls below 1 at %1"),
                            {table.gap(crossing.gap.value)}});
    return text;
}

std::string kinks(const GapStudy& study, const GapTable& table, const ReadingStyle& style) {
    std::string text;
    for (const GapKink& kink : study.statistics.kinks)
        text +=
            (text.empty() ? "" : ", ") + style.said({translatable("%1 (slope %2 to %3 per d0)"),
                                                     {table.gap(kink.gap), style.number(kink.slopeBefore, 3),
                                                      style.number(kink.slopeAfter, 3)}});
    if (text.empty()) return text;
    return style.said({translatable("Kinks of e at a gap of %1"), {text}});
}

double largestError(const GapStatistics& statistics) {
    double largest = 0;
    const auto take = [&](const Estimate& estimate) { largest = std::max(largest, estimate.error); };
    for (const GapOutputStatistics& output : statistics.outputs) {
        take(output.least.value);
        take(output.largest.value);
        for (const GapSpread& spread : {output.uniform, output.normal.value_or(output.uniform)}) {
            take(spread.mean);
            for (const Estimate& quantile : spread.quantiles) take(quantile);
        }
    }
    return largest;
}

}  // namespace

TextGrid gapGrid(const GapStudy& study, const ReadingStyle& style) {
    GapTable table(study.scenario, style);
    fill(table, study, style);
    return table.grid();
}

std::vector<std::string> gapRemarks(const GapStudy& study, const ReadingStyle& style) {
    const GapTable table(study.scenario, style);
    std::vector<std::string> remarks{superRebounds(study, table, style)};
    if (std::string places = kinks(study, table, style); !places.empty())
        remarks.push_back(std::move(places));
    if (study.normal)
        remarks.push_back(
            style.said(translatable("The scattered gap is a normal distribution cut off at zero; mean and "
                                    "deviation are those before the cut.")));
    remarks.push_back(
        style.said({study.curve.solves == 1 ? translatable("Errors below %1, from %2 blow")
                                            : translatable("Errors below %1, from %2 blows"),
                    {style.number(largestError(study.statistics), 2), std::to_string(study.curve.solves)}}));
    return remarks;
}

std::string gapText(const GapStudy& study, const ReadingStyle& style) {
    const auto line = [&](const Message& words) { return "  " + style.said(words) + "\n"; };
    std::string text = headingOf(study.scenario, style);
    if (study.curve.dependsOnGap)
        text += line(hasUnits(study.scenario) ? Message(translatable("The gap has a period of d0 = %1."),
                                                        {GapTable(study.scenario, style).gap(1)})
                                              : translatable("The gap has a period of d0."));
    if (const Message remark = periodRemark(study, style); !remark.isEmpty()) text += line(remark);
    text += "\n" + gapGrid(study, style).text() + "\n";
    std::vector<std::string> remarks = gapRemarks(study, style);
    remarks.back() = style.said(
        {translatable("%1 in %2."), {remarks.back(), style.quantity(study.runTime, Quantity::time, 3)}});
    for (const std::string& remark : remarks) text += "  " + remark + "\n";
    return text;
}

}  // namespace drillwave
