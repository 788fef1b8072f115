// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/sweep_panels.h"

#include <algorithm>

#include "ui/pages/study/output_box.h"
#include "ui/pages/study/parameter_names.h"

namespace drillwave {
namespace {

// "rod length L [m]".
QString axisLabel(const SweepAxis& axis) {
    const QString name = axis.parameter ? parameterName(*axis.parameter)
                         : axis.presets ? QString::fromUtf8(axis.key().data(), qsizetype(axis.key().size()))
                                        : QStringLiteral("pulse shape");
    const QString unit =
        axis.unit ? QString::fromUtf8(axis.unit->name.data(), qsizetype(axis.unit->name.size())) : QString();
    return unit.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, unit);
}

// "peak force [N]", or as a multiple of what it is measured in.
QString outputLabel(const OutputColumn& column) {
    const std::string header = column.header();
    const QString name = outputName(*column.output);
    if (const std::size_t unit = header.find(" ["); unit != std::string::npos)
        return name + QString::fromStdString(header.substr(unit));
    switch (column.output->measure) {
        case Measure::time:
            return name + QStringLiteral(" / t₀");
        case Measure::impulse:
            return name + QStringLiteral(" / I₀");
        case Measure::force:
            return name + QStringLiteral(" / F₀");
        case Measure::penetration:
            return name + QStringLiteral(" / d₀");
        case Measure::stress:
            return name + QStringLiteral(" / (F₀/A)");
        case Measure::velocity:
            return name + QStringLiteral(" / v₀");
        default:
            return name;
    }
}

// "γ = 0.1", "rectangular".
std::string valueLabel(const SweepAxis& axis, std::uint64_t i) {
    std::string text;
    axis.column().appendText(text, axis.value(i));
    if (!axis.parameter) return text;
    const std::string unit = axis.unit ? std::string(axis.unit->name) : std::string();
    return parameterName(*axis.parameter).toStdString() + " = " + text + (unit.empty() ? "" : " " + unit);
}

struct Point {
    double x;
    double y;
};

// Returns one output of the rows at the i-th value of the family axis, by growing x.
std::vector<Point> pointsOf(const SweepRows& rows, std::size_t along, std::uint64_t line,
                            std::size_t output) {
    const SweepAxis& axis = rows.axes[along];
    const bool hasFamily = rows.axes.size() == 2;
    const std::uint64_t lines = hasFamily ? rows.axes[1 - along].count : 1;
    std::vector<Point> points;
    for (std::uint64_t i = 0; i < axis.count; ++i) {
        // Later axes are fastest.
        const std::uint64_t row = along == 0 ? i * lines + line : line * axis.count + i;
        const double* numbers = rows.numbers.data() + row * rows.width();
        const double x = axis.unit ? axis.unit->fromSi(numbers[along]) : numbers[along];
        points.push_back({x, numbers[rows.axes.size() + output]});
    }
    std::ranges::stable_sort(points, {}, &Point::x);
    return points;
}

}  // namespace

std::vector<FigurePanel> sweepPanels(const SweepRows& rows) {
    const std::size_t along = lineAxis(rows.axes);
    const SweepAxis* family = rows.axes.size() == 2 ? &rows.axes[1 - along] : nullptr;
    std::vector<FigurePanel> panels;
    for (std::size_t output = 0; output < rows.columns.size(); ++output) {
        FigurePanel panel;
        panel.xLabel = axisLabel(rows.axes[along]).toStdString();
        panel.yLabel = outputLabel(rows.columns[output]).toStdString();
        panel.logarithmicX = rows.axes[along].kind == SweepAxis::Kind::logarithmic;
        for (std::uint64_t line = 0; line < (family ? family->count : 1); ++line) {
            FigureCurve curve;
            curve.label = family ? valueLabel(*family, line) : panel.yLabel;
            curve.colour = static_cast<int>(line);
            for (const Point& point : pointsOf(rows, along, line, output)) {
                curve.x.push_back(point.x);
                curve.y.push_back(point.y);
            }
            panel.curves.push_back(std::move(curve));
        }
        panels.push_back(std::move(panel));
    }
    return panels;
}

}  // namespace drillwave
