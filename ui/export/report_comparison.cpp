// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_comparison.h"

#include <algorithm>

#include "core/study/thrust/thrust_margins.h"
#include "ui/export/paper_plots.h"
#include "ui/pages/blow/blow_curves.h"
#include "ui/pages/blow/measured_force.h"
#include "ui/pages/compare/compare_table.h"
#include "ui/runs/difference_text.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

ReportCell cellOf(const CompareRow& row, std::size_t column, const QLocale& locale) {
    return {row.text(column, locale).toStdString(), row.hasNumbers() ? row.numbers[column] : std::nullopt};
}

/// The title of a run; where others have its name too, with what distinguishes it from the blow of the
/// report.
QString titleOf(const Run& run, const RunList& runs, const Scenario& reported, const UnitChoice& units) {
    if (std::ranges::count(runs, run.name, &Run::name) < 2) return run.title();
    const QString changes = changeWords(reported, run.contents.scenario, units);
    return changes.isEmpty() ? run.title() : QStringLiteral("%1 (%2)").arg(run.title(), changes);
}

}  // namespace

RunList withMargins(const RunList& runs, const std::stop_token& stop) {
    RunList known;
    for (Run run : runs) {
        if (run.isSolved() && (!run.blow->feed || !run.blow->feed->isOfAllGaps())) {
            auto blow = std::make_shared<SolvedBlow>(*run.blow);
            addThrustMargin(*blow, stop);
            run.blow = std::move(blow);
        }
        known.push_back(std::move(run));
    }
    return known;
}

ReportComparison comparisonWith(const RunList& runs, const Blow& blow, const UnitChoice& units) {
    const PaperReader reader = PaperReader::of(units);
    SolvedBlow own;
    static_cast<Blow&>(own) = blow;
    std::vector<CompareColumn> columns{{tr("this report"), &blow.scenario, &own, blow.feed}};
    for (const Run& run : runs)
        if (run.isSolved())
            columns.push_back({titleOf(run, runs, blow.scenario, units), &run.contents.scenario,
                               run.blow.get(), run.blow->feed});
    if (columns.size() == 1) return {};
    const UnitSystem system = reader.unitsFor(blow.scenario).system;
    const auto tableNow = [&] { return compareTable(columns, 0, system, reader.chosen, units); };
    const CompareTable table = tableNow();
    const CompareTable english = [&] {
        const EnglishTexts texts;
        return tableNow();
    }();
    ReportComparison comparison;
    for (const QString& title : table.titles) comparison.titles.push_back(title.toStdString());
    const auto label = [](const CompareRow& row) {
        return (row.unit.isEmpty() ? row.name : QStringLiteral("%1 [%2]").arg(row.name, row.unit))
            .toStdString();
    };
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const CompareRow& row = table.rows[i];
        if (row.kind == CompareRow::Kind::heading) continue;
        comparison.rows.push_back({label(english.rows[i]), label(row), {}});  // keys are the same everywhere
        for (std::size_t column = 0; column < columns.size(); ++column)
            comparison.rows.back().cells.push_back(cellOf(row, column, reader.locale));
    }
    return comparison;
}

ReportComparison misfitsOf(const std::vector<MeasuredSignal>& measured, const Blow& blow,
                           const UnitChoice& units) {
    if (measured.empty()) return {};
    const PaperReader reader = PaperReader::of(units);
    const ShownUnits shown = reader.unitsFor(blow.scenario);
    const Scales scales = scalesOf(blow.scenario);
    const BlowCurves curves = blowCurves(blow, shown, shareOnPaper(blow.scenario, measured), Tail::cut);
    const auto cell = [&](std::optional<double> si, const ShownUnit& unit, double scale) -> ReportCell {
        if (!si) return {};
        return {quantityText(*si / scale, unit, reader.locale).toStdString(), *si / scale * unit.factor};
    };
    ReportComparison comparison{.titles = {}, .rows = {}};
    for (const QString& title : {tr("what"), tr("shift"), tr("rms"), tr("peaks differ by"), tr("lag")})
        comparison.titles.push_back(title.toStdString());
    for (const MeasuredSignal& signal : measured) {
        const std::optional<Misfit> misfit = misfitOf(signal, computedForce(blow, signal, curves));
        const bool isInside = signal.quantity == MeasuredQuantity::normalForce;
        const QString place = quantityText(
            signal.place, shownUnit(reader.unitFor(*findParameter("rod.length"))), reader.locale);
        const QString what = isInside ? tr("force N at %1").arg(place) : tr("impact force");
        ReportRow row{signal.name, signal.name, {}};
        row.cells.push_back({what.toStdString(), {}});
        row.cells.push_back(cell(signal.timeShift, shown.time, scales.time));
        const auto of = [&](double Misfit::*force) {
            return misfit ? cell((*misfit).*force, shown.force, scales.force) : ReportCell{};
        };
        row.cells.push_back(of(&Misfit::rms));
        row.cells.push_back(of(&Misfit::peakDifference));
        row.cells.push_back(misfit ? cell(misfit->lag, shown.time, scales.time) : ReportCell{});
        comparison.rows.push_back(std::move(row));
    }
    return comparison;
}

}  // namespace drillwave
