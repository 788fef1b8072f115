// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of controls one below the other that can be added and removed.
#pragma once

#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

namespace drillwave {

/// The rows of a widget, which owns them and all that is given here. A `Row` is a QWidget with a signal
/// removed() and setRemovable().
template <class Row>
class RowList {
  public:
    /// Holds at least and at most so many rows; new ones are inserted before the button `add`, or last if
    /// that is in another layout.
    RowList(QVBoxLayout& layout, QToolButton& add, std::size_t least, std::size_t most)
        : m_layout(layout), m_add(add), m_least(least), m_most(most) {}

    const std::vector<Row*>& rows() const { return m_rows; }
    bool isFull() const { return m_rows.size() >= m_most; }

    /// Calls `whenRemoved` after the row has gone by its own button.
    template <class Told>
    void append(Row* row, Told whenRemoved) {
        m_layout.insertWidget(m_layout.indexOf(&m_add), row);
        m_rows.push_back(row);
        QObject::connect(row, &Row::removed, row, [this, row, whenRemoved] {
            remove(row);
            whenRemoved();
        });
        row->show();
        showButtons();
    }
    /// Requires that there is one.
    void removeLast() { remove(m_rows.back()); }
    void clear() {
        while (!m_rows.empty()) remove(m_rows.back());
    }

  private:
    void remove(Row* row) {
        std::erase(m_rows, row);
        m_layout.removeWidget(row);
        row->hide();
        row->deleteLater();
        showButtons();
    }
    void showButtons() {
        m_add.setVisible(!isFull());
        for (Row* row : m_rows) row->setRemovable(m_rows.size() > m_least);
    }

    QVBoxLayout& m_layout;
    QToolButton& m_add;
    std::size_t m_least, m_most;
    std::vector<Row*> m_rows;
};

}  // namespace drillwave
