// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers behind the plots of a page, to be read and copied: what its exports write.
#pragma once

#include <QDialog>
#include <QList>
#include <utility>

class QTableView;

namespace drillwave {

class NumbersWindow : public QDialog {
    Q_OBJECT

  public:
    /// Titles with the CSV behind them, at least one.
    NumbersWindow(const QString& title, const QList<std::pair<QString, QByteArray>>& tables, QWidget* parent);

  private:
    QTableView* makeView(const QString& title, const QByteArray& csv);
};

}  // namespace drillwave
