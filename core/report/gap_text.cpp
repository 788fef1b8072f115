// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/gap_text.h"

#include <algorithm>

#include "core/model/scales.h"
#include "core/report/report_text.h"

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

    void addHeading(const std::string& title) {
        m_grid.add({title, "e", m_dimensional ? "impulse" : "impulse/I0",
                    m_dimensional ? "peak force" : "peak force/F0", "efficiency"});
    }

    /// One line of `value(output)`.
    template <class Value>
    void add(const std::string& label, const Value& value) {
        const double impulse = 1 + value(GapOutput::cor), force = value(GapOutput::peakForce);
        const double efficiency = value(GapOutput::efficiency);
        m_grid.add({label, m_style.number(value(GapOutput::cor), gapDigits),
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
            if (found.kind == GapExtreme::Kind::everywhere) return std::string("anywhere");
            return gap(found.gap.value) + (found.kind == GapExtreme::Kind::kink ? " kink" : "");
        };
        const std::string cor = place(GapOutput::cor);
        m_grid.add({"  at a gap of", cor, cor, place(GapOutput::peakForce), place(GapOutput::efficiency)});
    }

    void addBlankLine() { m_grid.add({""}); }
    const TextGrid& grid() const { return m_grid; }

  private:
    bool m_dimensional;
    Scales m_scales;
    const ReadingStyle& m_style;
    TextGrid m_grid;
};

std::string quantileLabel(std::size_t i, const ReadingStyle& style) {
    return gapQuantiles[i] == 0.5 ? "median" : style.number(gapQuantiles[i] * 100, 3) + " % quantile";
}

template <class SpreadOf>
void addSpread(GapTable& table, const SpreadOf& spread, const ReadingStyle& style) {
    table.add("mean", [&](GapOutput output) { return spread(output).mean.value; });
    for (std::size_t i = 0; i < gapQuantiles.size(); ++i)
        table.add(quantileLabel(i, style),
                  [&](GapOutput output) { return spread(output).quantiles[i].value; });
}

void fill(GapTable& table, const GapReport& report, const ReadingStyle& style) {
    const GapStatistics& statistics = report.statistics;
    table.addHeading("all gaps alike");
    table.add("smallest", [&](GapOutput output) { return statistics.of(output).least.value.value; });
    table.addGaps([&](GapOutput output) -> const GapExtreme& { return statistics.of(output).least; });
    table.add("largest", [&](GapOutput output) { return statistics.of(output).largest.value.value; });
    table.addGaps([&](GapOutput output) -> const GapExtreme& { return statistics.of(output).largest; });
    addSpread(
        table, [&](GapOutput output) -> const GapSpread& { return statistics.of(output).uniform; }, style);
    if (report.normal) {
        table.addBlankLine();
        table.addHeading("gap " + table.gap(report.normal->mean) + " +- " +
                         table.gap(report.normal->deviation));
        addSpread(
            table, [&](GapOutput output) -> const GapSpread& { return *statistics.of(output).normal; },
            style);
    }
}

std::string shareOfGaps(double share, const ReadingStyle& style) {
    return style.number(share * 100, 5) + " %";
}

std::string superRebounds(const GapReport& report, const GapTable& table, const ReadingStyle& style) {
    const GapStatistics& statistics = report.statistics;
    std::string text = "e > 1 at " + shareOfGaps(statistics.shareAboveOne.value, style) + " of all gaps";
    if (report.normal)
        text += ", " + shareOfGaps(statistics.normalShareAboveOne->value, style) + " of the scattered ones";
    for (const GapCrossing& crossing : statistics.crossings)
        text += (&crossing == &statistics.crossings.front() ? ": " : ", ") +
                std::string(crossing.rising ? "rises above 1 at " : "falls below 1 at ") +
                table.gap(crossing.gap.value);
    return text;
}

std::string kinks(const GapReport& report, const GapTable& table, const ReadingStyle& style) {
    std::string text;
    for (const GapKink& kink : report.statistics.kinks)
        text += (text.empty() ? "Kinks of e at a gap of " : ", ") + table.gap(kink.gap) + " (slope " +
                style.number(kink.slopeBefore, 3) + " to " + style.number(kink.slopeAfter, 3) + " per d0)";
    return text;
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

TextGrid gapGrid(const GapReport& report, const ReadingStyle& style) {
    GapTable table(report.scenario, style);
    fill(table, report, style);
    return table.grid();
}

std::vector<std::string> gapRemarks(const GapReport& report, const ReadingStyle& style) {
    const GapTable table(report.scenario, style);
    std::vector<std::string> remarks{superRebounds(report, table, style)};
    if (std::string places = kinks(report, table, style); !places.empty())
        remarks.push_back(std::move(places));
    if (report.normal)
        remarks.emplace_back(
            "The scattered gap is a normal distribution cut off at no gap: mean and deviation are those "
            "before the cut.");
    remarks.push_back("Errors below " + style.number(largestError(report.statistics), 2) + ", from " +
                      std::to_string(report.curve.solves) + (report.curve.solves == 1 ? " blow" : " blows"));
    return remarks;
}

std::string gapText(const GapReport& report) {
    const GapTable table(report.scenario, plainStyle());
    std::string text = headingOf(report.scenario);
    if (report.curve.dependsOnGap)
        text += "  The gap has a period of d0" +
                (hasUnits(report.scenario) ? " = " + table.gap(1) : std::string()) + ".\n";
    if (const std::string remark = report.periodRemark(); !remark.empty()) text += "  " + remark + "\n";
    text += "\n" + gapGrid(report).text();
    for (const std::string& remark : gapRemarks(report)) text += "\n  " + remark;
    return text + " in " + inHandyUnit(report.runTime, Quantity::time, 3) + ".\n";
}

}  // namespace drillwave
