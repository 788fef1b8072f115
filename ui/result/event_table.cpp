// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/event_table.h"

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QScopedValueRollback>

#include "ui/result/event_model.h"

namespace drillwave {
namespace {

constexpr int visibleEvents = 7;

}  // namespace

EventTable::EventTable(QWidget* parent) : QTableView(parent), m_model(new EventModel(this)) {
    setAccessibleName(tr("Events at the bit"));
    setModel(m_model);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setShowGrid(false);
    setAlternatingRowColors(true);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    horizontalHeader()->setStretchLastSection(true);
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    horizontalHeader()->setResizeContentsPrecision(visibleEvents);  // not of thousands of rows
    setContextMenuPolicy(Qt::NoContextMenu);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setToolTip(tr("Choose an event to move the time cursor there"));
    setTabKeyNavigation(false);
    const int header = horizontalHeader()->sizeHint().height();
    setMinimumHeight(header + visibleEvents * verticalHeader()->defaultSectionSize());
    connect(selectionModel(), &QItemSelectionModel::currentRowChanged, this, &EventTable::choose);
    // The row that is current already can be chosen again when the cursor has gone elsewhere.
    connect(this, &QTableView::clicked, this, &EventTable::choose);
    connect(this, &QTableView::activated, this, &EventTable::choose);
}

void EventTable::present(const SolvedBlowPtr& blow) {
    m_model->present(blow);
    markEvent();
}

void EventTable::setTime(std::optional<double> time) {
    m_time = time;
    markEvent();
}

// The keyboard comes by on its way: that makes a row the current one, and chooses no time.
void EventTable::focusInEvent(QFocusEvent* event) {
    const QScopedValueRollback following(m_following, true);
    QTableView::focusInEvent(event);
}

void EventTable::choose(const QModelIndex& index) {
    if (index.isValid() && !m_following) emit timeChosen(m_model->timeAt(index.row()));
}

void EventTable::markEvent() {
    const QScopedValueRollback following(m_following, true);
    const QModelIndex current = currentIndex();
    const bool isThere = m_time && current.isValid() && m_model->timeAt(current.row()) == *m_time;
    const std::optional<int> row = isThere ? current.row() : m_time ? m_model->rowAt(*m_time) : std::nullopt;
    if (!row) {
        clearSelection();
        return;
    }
    selectRow(*row);
}

}  // namespace drillwave
