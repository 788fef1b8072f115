// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/drilling/drilling_table.h"

#include <QHeaderView>
#include <QScrollBar>

#include "core/report/drilling_report.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

enum Column { mean, error, deviation, low, median, high, columns };

/// Places in blowQuantities of those that have a row.
std::vector<std::size_t> rowsOfTable() {
    std::vector<std::size_t> rows;
    for (std::size_t q = 0; q < blowQuantities.size(); ++q)
        if (blowQuantities[q].title) rows.push_back(q);
    return rows;
}

}  // namespace

DrillingTable::DrillingTable(QWidget* parent) : QTableWidget(parent), m_rows(rowsOfTable()) {
    setRowCount(int(m_rows.size()));
    setColumnCount(columns);
    setObjectName(QStringLiteral("statistics"));
    setAccessibleName(tr("Statistics of the blows"));
    setHorizontalHeaderLabels({tr("mean"), QStringLiteral("±"), tr("deviation"), QStringLiteral("5 %"),
                               tr("median"), QStringLiteral("95 %")});
    horizontalHeaderItem(error)->setToolTip(
        tr("95 % error of the mean, from batches of blows and from longer and shorter time steps"));
    for (int row = 0; row < rowCount(); ++row) {
        const BlowQuantity& quantity = blowQuantities[m_rows[std::size_t(row)]];
        auto* header = new QTableWidgetItem(translated(Message(quantity.title)));
        header->setToolTip(translated(Message(quantity.meaning)));
        setVerticalHeaderItem(row, header);
        for (int column = 0; column < columns; ++column) {
            auto* cell = new QTableWidgetItem;
            cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            setItem(row, column, cell);
        }
    }
    setEditTriggers(NoEditTriggers);
    setTabKeyNavigation(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setStretchLastSection(true);
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setWordWrap(false);
}

void DrillingTable::setText(int row, int column, const QString& text) {
    item(row, column)->setText(text);
    item(row, column)->setToolTip(text);
}

void DrillingTable::present(const DrillingResult& result, const UnitChoice& units) {
    const LocalStyle style = LocalStyle::of(units);
    for (int row = 0; row < rowCount(); ++row) {
        const std::size_t quantity = m_rows[std::size_t(row)];
        const DrillingMeasure measure = blowQuantities[quantity].measure;
        const DrillingScale scale = scaleOf(measure, result);
        const BlowSpread& spread = result.spread(quantity);
        // In one unit, beside its name: cells with units are too wide for the last column to be seen.
        const ReadUnit read = measure == DrillingMeasure::count
                                  ? ReadUnit{&unitsOf(Quantity::ratio).front(), {}}
                                  : style.unitFor(scale.value(spread.q95, OutputUnits::si), scale.quantity);
        const QString title = translated(Message(blowQuantities[quantity].title));
        verticalHeaderItem(row)->setText(
            read.name.empty() ? title
                              : QStringLiteral("%1 [%2]").arg(title, QString::fromStdString(read.name)));
        const auto text = [&](double value, int digits) {
            const double shown = read.unit->fromSi(scale.value(value, OutputUnits::si));
            return QString::fromStdString(style.number(shown, digits));
        };
        const std::optional<double> errorOfMean = result.meanError(quantity);
        setText(row, mean, text(spread.mean, 5));
        setText(row, error, errorOfMean ? text(withoutRounding(*errorOfMean), 2) : QString());
        setText(row, deviation, text(withoutRounding(spread.deviation), 3));
        setText(row, low, text(spread.q05, 4));
        setText(row, median, text(spread.q50, 4));
        setText(row, high, text(spread.q95, 4));
    }
}

void DrillingTable::clearNumbers() {
    for (int row = 0; row < rowCount(); ++row)
        for (int column = 0; column < columns; ++column) setText(row, column, {});
}

// All rows in view, whatever the font.
QSize DrillingTable::sizeHint() const {
    return {500, horizontalHeader()->sizeHint().height() + verticalHeader()->length() + 2 * frameWidth()};
}

QSize DrillingTable::minimumSizeHint() const {
    return {200, sizeHint().height() + horizontalScrollBar()->sizeHint().height()};
}

}  // namespace drillwave
