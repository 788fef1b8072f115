// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/accuracy/proof_table.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/report/accuracy_columns.h"
#include "ui/pages/accuracy/proof_picture.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

QString numberCell(double value, NumberStyle style) {
    const QLocale locale;
    if (std::isnan(value)) return noNumber;
    switch (style) {
        case NumberStyle::error:
            return magnitudeText(value, locale);
        case NumberStyle::time:
            return runTimeText(value, locale);
        case NumberStyle::count:
            return locale.toString(static_cast<qlonglong>(value));
        case NumberStyle::factor:
        case NumberStyle::order:
            break;
    }
    return numberText(value, 3, locale);
}

// Those of the table of the command.
std::vector<const StudyColumn<AccuracyRow>*> shownColumns() {
    std::vector<const StudyColumn<AccuracyRow>*> columns;
    for (const StudyColumn<AccuracyRow>& column : accuracyColumns)
        if (!column.title.empty()) columns.push_back(&column);
    return columns;
}

std::vector<std::size_t> numbered(std::size_t size) {
    std::vector<std::size_t> order(size);
    std::iota(order.begin(), order.end(), std::size_t{0});
    return order;
}

QString stabilityCell(const StabilityRow& row, int column) {
    const QLocale locale;
    const Groups& groups = row.stabilityCase.groups;
    const bool isSolved = row.outcome == Outcome::rebounded;
    const StabilityWorst worst = worstOf(row);
    switch (column) {
        case 0:
            return QString::fromStdString(row.stabilityCase.name);
        case 1:
            return coreText(worst.measure);
        case 2:
            return isSolved ? numberText(100 * worst.ratio, 2, locale) + QStringLiteral(" %")
                            : translated(row.reason);
        case 3:
            return coreName(name(row.stabilityCase.shape));
        case 4:
            return numberText(groups.beta, 4, locale);
        case 5:
            return numberText(groups.gamma, 4, locale);
        case 6:
            return numberText(groups.tau, 4, locale);
        case 7:
            return numberText(groups.delta, 4, locale);
        case 8:
            return isSolved ? numberText(row.cor, 4, locale) : noNumber;
        case 9:
            return isSolved ? magnitudeText(row.corError, locale) : noNumber;
        default:
            return locale.toString(static_cast<qlonglong>(row.pieces));
    }
}

}  // namespace

void ProofTable::take(const QStringList& titles, std::vector<std::size_t> order, Cell cell) {
    beginResetModel();
    m_titles = titles;
    m_order = std::move(order);
    m_cell = std::move(cell);
    endResetModel();
}

void ProofTable::present(std::shared_ptr<const Accuracy> accuracy) {
    QStringList titles{tr("method")};
    for (const StudyColumn<AccuracyRow>* column : shownColumns()) titles << coreText(column->title);
    const std::size_t rows = accuracy->rows.size();
    take(titles, numbered(rows), [accuracy, columns = shownColumns()](std::size_t i, int column) {
        const AccuracyRow& row = accuracy->rows[i];
        if (column == 0) return rowName(row);
        if (row.outcome != Outcome::rebounded) return column == 1 ? translated(row.reason) : QString();
        const StudyColumn<AccuracyRow>& shown = *columns[static_cast<std::size_t>(column - 1)];
        // What follows from all rows is there when they are.
        const bool isMissing = !accuracy->isRelated && (shown.key == "order" || shown.key == "speed");
        return isMissing ? noNumber : numberCell(shown.value(row), shown.style);
    });
}

void ProofTable::present(std::shared_ptr<const StringAccuracy> accuracy) {
    QStringList titles{tr("method")};
    for (const StudyColumn<StringAccuracyRow>& column : stringAccuracyColumns)
        titles << coreText(column.title);
    const std::size_t rows = accuracy->rows.size();
    take(titles, numbered(rows), [accuracy](std::size_t i, int column) {
        const StringAccuracyRow& row = accuracy->rows[i];
        if (column == 0) return rowName(row);
        const StudyColumn<StringAccuracyRow>& shown =
            stringAccuracyColumns[static_cast<std::size_t>(column - 1)];
        return numberCell(shown.value(row), shown.style);
    });
}

void ProofTable::present(std::shared_ptr<const StabilityReport> report) {
    const QStringList titles{tr("case"),          tr("worst check"),   tr("of its limit"),
                             tr("shape"),         QStringLiteral("β"), QStringLiteral("γ"),
                             QStringLiteral("τ"), QStringLiteral("δ"), tr("e"),
                             tr("error of e"),    tr("pieces")};
    std::vector<double> ratios;
    for (const StabilityRow& row : report->rows) ratios.push_back(worstOf(row).ratio);
    std::vector<std::size_t> order = numbered(ratios.size());
    std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t i) { return ratios[i]; });
    take(titles, std::move(order),
         [report](std::size_t i, int column) { return stabilityCell(report->rows[i], column); });
}

void ProofTable::clear() {
    take({}, {}, {});
}

int ProofTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_order.size());
}

int ProofTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_titles.size());
}

QVariant ProofTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole)
        return m_cell(studyRow(index.row()), index.column());
    if (role == Qt::TextAlignmentRole && index.column() > 0) return int(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant ProofTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole || orientation != Qt::Horizontal) return {};
    return m_titles.value(section);
}

}  // namespace drillwave
