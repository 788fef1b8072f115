// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/identify/record_list.h"

#include <QAction>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr int mostRows = 6, leastRows = 2;  // in view
constexpr int leastListWidth = 200;         // [px]

}  // namespace

RecordList::RecordList(QWidget* parent) : QTableWidget(0, 4, parent) {
    setObjectName(QStringLiteral("records"));
    setAccessibleName(tr("Records"));
    setHorizontalHeaderLabels({tr("record"), tr("verdict"), tr("misfit"), QString()});
    setToolTip(tr("A click shows a record; Delete removes it from the list"));
    verticalHeader()->hide();
    setEditTriggers(NoEditTriggers);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setTabKeyNavigation(false);
    setWordWrap(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    connect(this, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (row >= 0) emit chosen(row);
    });
    auto* remove = new QAction(this);
    remove->setShortcut(QKeySequence::Delete);
    remove->setShortcutContext(Qt::WidgetShortcut);
    addAction(remove);
    connect(remove, &QAction::triggered, this, [this] {
        if (currentRow() >= 0) emit removeWanted(m_rows[static_cast<std::size_t>(currentRow())].path);
    });
}

void RecordList::present(std::vector<Row> rows, int shown) {
    const QSignalBlocker quiet(this);
    if (rows != m_rows) {
        m_rows = std::move(rows);
        setRowCount(0);
        setRowCount(static_cast<int>(m_rows.size()));
        for (int row = 0; row < rowCount(); ++row) {
            const Row& each = m_rows[static_cast<std::size_t>(row)];
            const QStringList texts{each.record, each.verdict, each.misfit};
            for (int column = 0; column < int(texts.size()); ++column) {
                auto* item = new QTableWidgetItem(texts[column]);
                item->setToolTip(withoutMarkup(column == 0 ? each.path : texts[column]));
                setItem(row, column, item);
            }
            addRemoval(row);
        }
        updateGeometry();
    }
    setCurrentCell(shown, 0);
}

void RecordList::addRemoval(int row) {
    const Row& each = m_rows[static_cast<std::size_t>(row)];
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("remove"));
    button->setText(QStringLiteral("✕"));
    button->setAutoRaise(true);
    button->setAccessibleName(tr("Remove %1").arg(each.record));
    button->setToolTip(tr("Removes this record from the list; the file stays"));
    connect(button, &QToolButton::clicked, this, [this, path = each.path] { emit removeWanted(path); });
    setCellWidget(row, 3, button);
}

int RecordList::heightOf(int rows) const {
    const int row = rowCount() > 0 ? rowHeight(0) : fontMetrics().lineSpacing();
    return horizontalHeader()->sizeHint().height() + std::min(rows, rowCount()) * row + 2 * frameWidth();
}

QSize RecordList::sizeHint() const {
    return {leastListWidth, heightOf(mostRows)};
}

QSize RecordList::minimumSizeHint() const {
    return {leastListWidth, heightOf(leastRows)};
}

}  // namespace drillwave
