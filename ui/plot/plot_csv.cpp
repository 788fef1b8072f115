// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_csv.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/text/csv.h"
#include "core/text/units.h"
#include "ui/plot/curve_names.h"
#include "ui/plot/legend_entries.h"

namespace drillwave {
namespace {

struct CsvColumn {
    QString name;
    std::vector<double> numbers;
};

template <class Points>
std::pair<std::vector<double>, std::vector<double>> numbersOf(const Points& points) {
    std::pair<std::vector<double>, std::vector<double>> numbers;
    for (auto point = points.constBegin(); point != points.constEnd(); ++point) {
        numbers.first.push_back(point->key);
        numbers.second.push_back(point->value);
    }
    return numbers;
}

std::pair<std::vector<double>, std::vector<double>> numbersOf(const QCPAbstractPlottable& curve) {
    if (const auto* graph = qobject_cast<const QCPGraph*>(&curve)) return numbersOf(*graph->data());
    if (const auto* path = qobject_cast<const QCPCurve*>(&curve)) return numbersOf(*path->data());
    return {};
}

QString keyName(const QCPAbstractPlottable& curve) {
    const QString label = xLabelOf(curve);
    return label.isEmpty() ? QStringLiteral("x") : label;
}

QString valueName(const QCPAbstractPlottable& curve, const CurveMeanings& meanings) {
    const auto meaning = meanings.constFind(&curve);
    if (meaning == meanings.constEnd())
        return curve.name() + QStringLiteral(", ") + curve.valueAxis()->label();
    return meaning->yUnit.isEmpty() ? curve.name()
                                    : curve.name() + QStringLiteral(" [%1]").arg(meaning->yUnit);
}

std::vector<CsvColumn> columnsOf(const QCustomPlot& plot, const CurveMeanings& meanings) {
    std::vector<CsvColumn> columns;
    std::size_t keys = 0;  // the column with the keys of the last curve
    for (const QCPAbstractPlottable* curve : visibleCurves(plot)) {
        auto [x, y] = numbersOf(*curve);
        if (x.empty()) continue;
        if (columns.empty() || columns[keys].numbers != x) {
            keys = columns.size();
            columns.push_back({keyName(*curve), std::move(x)});
        }
        columns.push_back({valueName(*curve, meanings), std::move(y)});
    }
    return columns;
}

// A tab or a line end in a name would break the table that has no quotes.
std::string cell(const QString& name, char separator) {
    if (separator == ',') return csvCell(name.toStdString());
    return name.simplified().toStdString();
}

}  // namespace

QByteArray plotCsv(const QCustomPlot& plot, const CurveMeanings& meanings, char separator) {
    const std::vector<CsvColumn> columns = columnsOf(plot, meanings);
    std::string text;
    std::size_t rows = 0;
    for (const CsvColumn& column : columns) {
        if (&column != &columns.front()) text += separator;
        text += cell(column.name, separator);
        rows = std::max(rows, column.numbers.size());
    }
    text += '\n';
    for (std::size_t row = 0; row < rows; ++row) {
        for (const CsvColumn& column : columns) {
            if (&column != &columns.front()) text += separator;
            if (row < column.numbers.size()) text += formatNumber(column.numbers[row]);
        }
        text += '\n';
    }
    return QByteArray::fromStdString(text);
}

}  // namespace drillwave
