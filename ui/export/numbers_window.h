// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of the plots of a page, to be read and copied: the contents of its exports.
#pragma once

#include <QDialog>
#include <QList>
#include <utility>

class QTableView;

namespace drillwave {

class NumbersWindow : public QDialog {
    Q_OBJECT

  public:
    /// Takes at least one title with its CSV.
    NumbersWindow(const QString& title, const QList<std::pair<QString, QByteArray>>& tables, QWidget* parent);

  private:
    QTableView* makeView(const QString& title, const QByteArray& csv);
};

}  // namespace drillwave
