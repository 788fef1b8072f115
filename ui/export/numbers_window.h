// SPDX-License-Identifier: GPL-3.0-or-later
// Window that shows the numbers of a page's plots as tables, to read and copy.
#pragma once

#include <QDialog>
#include <QList>
#include <utility>

class QTableView;

namespace drillwave {

class NumbersWindow : public QDialog {
    Q_OBJECT

  public:
    /// Makes a window that shows the tables, each given as a pair of title and CSV text. Requires at least
    /// one table.
    NumbersWindow(const QString& title, const QList<std::pair<QString, QByteArray>>& tables, QWidget* parent);

  private:
    QTableView* makeView(const QString& title, const QByteArray& csv);
};

}  // namespace drillwave
