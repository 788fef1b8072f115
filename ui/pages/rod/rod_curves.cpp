// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/rod/rod_curves.h"

#include <qcustomplot.h>

#include <algorithm>

#include "core/text/csv.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

constexpr const char* columnNames[] = {"compression", "tension", "compression of residual waves",
                                       "tension of residual waves"};

GraphData curveOf(const RodCurves& curves, Load line) {
    QVector<QCPGraphData> points;
    points.reserve(static_cast<qsizetype>(curves.forces(line).size()));
    for (const RodForce& force : curves.forces(line))
        appendFinite(points, curves.position(force), curves.stress(line, force));
    return graphData(points);
}

}  // namespace

RodForce RodCurves::forceAt(Load line, double section) const {
    if (!string) return drillwave::forceAt(forces(line), section);
    if (!string->waves) return {0, section, 0};
    return string->largestAt(section)[line];
}

RodCurves rodCurves(const Blow& blow, const ShownUnits& units, const std::stop_token& stop) {
    RodCurves curves;
    curves.units = units;
    curves.strengthFactor = units.stress.factor / scalesOf(blow.scenario).stress;
    if (StringRod string = stringRod(blow); !string.stretches.empty()) {
        curves.string = std::move(string);
        curves.envelope = stringRodEnvelope(*curves.string, blow, stop);
    } else {
        curves.envelope = rodEnvelope(blow.impact, blow.problem.force(), stop);
        if (hasUnits(blow.scenario)) {
            curves.yieldStrength = curves.shownStrength(blow.scenario.rod.yieldStrength);
            curves.fatigueStrength = curves.shownStrength(blow.scenario.rod.fatigueStrength);
        }
    }
    for (const Load line : loads) curves.curves[static_cast<std::size_t>(line)] = curveOf(curves, line);
    return curves;
}

QByteArray rodCsv(const RodCurves& curves, char separator) {
    std::string text;
    std::size_t rows = 0;
    const auto append = [&](const std::string& cell) {
        if (!text.empty() && text.back() != '\n') text += separator;
        text += cell;
    };
    const auto heading = [&](const char* name, const ShownUnit& unit) {
        append(csvCell(name + (" [" + unit.unit.toStdString() + "]")));
    };
    for (const Load line : curves.lines()) {
        heading("position", curves.units.length);
        heading(columnNames[static_cast<std::size_t>(line)], curves.units.stress);
        heading("time", curves.units.time);
        rows = std::max(rows, curves.forces(line).size());
    }
    text += '\n';
    for (std::size_t row = 0; row < rows; ++row) {
        std::string cells;
        for (const Load line : curves.lines()) {
            if (!cells.empty()) cells += separator;
            if (row >= curves.forces(line).size()) {
                cells += std::string(2, separator);
                continue;
            }
            const RodForce& force = curves.forces(line)[row];
            cells += formatNumber(curves.position(force)) + separator +
                     formatNumber(curves.stress(line, force)) + separator +
                     formatNumber(force.time * curves.units.time.factor);
        }
        text += cells + '\n';
    }
    return QByteArray::fromStdString(text);
}

}  // namespace drillwave
