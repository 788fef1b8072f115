// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/numbers_window.h"

#include <QAction>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/export/numbers_table.h"
#include "ui/questions/on_screen.h"

namespace drillwave {
namespace {

/// Returns cells in the form for other programs: tabs between cells, the heads of the columns above if more
/// than one cell is copied.
QString copied(const QTableView& view) {
    QModelIndexList chosen = view.selectionModel()->selectedIndexes();
    std::sort(chosen.begin(), chosen.end());
    QString text, heads;
    for (qsizetype i = 0; i < chosen.size(); ++i) {
        const bool isFirst = i == 0 || chosen[i].row() != chosen[i - 1].row();
        if (i > 0) text += isFirst ? u'\n' : u'\t';
        text += chosen[i].data().toString();
        if (chosen[i].row() != chosen[0].row()) continue;
        heads += (i > 0 ? QStringLiteral("\t") : QString()) +
                 view.model()->headerData(chosen[i].column(), Qt::Horizontal).toString();
    }
    return chosen.size() > 1 ? heads + u'\n' + text : text;
}

}  // namespace

NumbersWindow::NumbersWindow(const QString& title, const QList<std::pair<QString, QByteArray>>& tables,
                             QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(title);
    setObjectName(QStringLiteral("numbers"));
    auto* layout = new QVBoxLayout(this);
    if (tables.size() == 1) {
        layout->addWidget(makeView(title, tables.front().second));
    } else {
        auto* tabs = new QTabWidget(this);
        for (const auto& [name, csv] : tables) tabs->addTab(makeView(name, csv), name);
        layout->addWidget(tabs);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    resize(firstSize(*this, {760, 560}));
}

QTableView* NumbersWindow::makeView(const QString& title, const QByteArray& csv) {
    auto* view = new QTableView(this);
    auto* numbers = new NumbersTable(csv, locale(), view);
    view->setModel(numbers);
    view->setAccessibleName(title);
    view->setAccessibleDescription(
        tr("%1 rows, %2 columns").arg(numbers->rowCount()).arg(numbers->columnCount()));
    view->setTabKeyNavigation(false);  // Tab leaves the table
    constexpr int air = 6;             // above and below a line, together
    view->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + air);
    view->horizontalHeader()->setResizeContentsPrecision(100);
    view->resizeColumnsToContents();
    auto* copy = new QAction(tr("&Copy"), view);
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetShortcut);
    connect(copy, &QAction::triggered, view,
            [view] { QGuiApplication::clipboard()->setText(copied(*view)); });
    view->addAction(copy);
    view->setContextMenuPolicy(Qt::ActionsContextMenu);
    return view;
}

}  // namespace drillwave
