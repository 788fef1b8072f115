// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/answer_table.h"

#include <QHeaderView>
#include <QScrollBar>

#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

QTableWidgetItem* titleItem(const StudyTable::Title& title) {
    auto* item = new QTableWidgetItem(translated(title.text));
    item->setToolTip(translated(title.tip));
    return item;
}

}  // namespace

AnswerTable::AnswerTable(const QString& accessibleName, QWidget* parent) : QTableWidget(parent) {
    setObjectName(QStringLiteral("answerTable"));
    setAccessibleName(accessibleName);
    setEditTriggers(NoEditTriggers);
    setTabKeyNavigation(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);  // scrolled, never cut
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setWordWrap(false);
}

void AnswerTable::present(const StudyTable& table) {
    const auto columns = static_cast<int>(table.columns.size()), rows = static_cast<int>(table.rows.size());
    const bool isOther = rows != rowCount();
    setColumnCount(columns);
    setRowCount(rows);
    for (int column = 0; column < columns; ++column)
        setHorizontalHeaderItem(column, titleItem(table.columns[std::size_t(column)]));
    for (int row = 0; row < rows; ++row) {
        setVerticalHeaderItem(row, titleItem(table.rows[std::size_t(row)]));
        for (int column = 0; column < columns; ++column) {
            const StudyTable::Cell& cell = table.cells[std::size_t(row)][std::size_t(column)];
            const QString text = QString::fromStdString(cell.text), more = QString::fromStdString(cell.more);
            auto* item = new QTableWidgetItem(text);
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            item->setToolTip(more.isEmpty() ? text : text + QStringLiteral(" · ") + more);
            setItem(row, column, item);
        }
    }
    if (isOther) updateGeometry();
    stretch();
}

// A last column that stretches also shrinks where there is no room.
void AnswerTable::stretch() {
    QHeaderView& header = *horizontalHeader();
    header.setStretchLastSection(false);
    header.resizeSections(QHeaderView::ResizeToContents);
    header.setStretchLastSection(header.length() <= viewport()->width());
}

void AnswerTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    stretch();
}

// All rows in view, whatever the font.
QSize AnswerTable::sizeHint() const {
    return {500, heightOf(verticalHeader()->length())};
}

QSize AnswerTable::minimumSizeHint() const {
    // The page scrolls before its table does, which only scrolls sideways.
    return {200, sizeHint().height() + horizontalScrollBar()->sizeHint().height()};
}

int AnswerTable::heightOf(int contents) const {
    return horizontalHeader()->sizeHint().height() + contents + 2 * frameWidth();
}

}  // namespace drillwave
