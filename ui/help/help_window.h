// SPDX-License-Identifier: GPL-3.0-or-later
// Window of the manual: table of contents, search and chapter.
#pragma once

#include <QLineEdit>
#include <QListWidget>
#include <QSplitter>
#include <QStackedWidget>
#include <QTreeWidget>

#include "ui/help/help_view.h"
#include "ui/help/manual_search.h"

namespace drillwave {

/// Window of the manual, separate from the main window. It stores its place, layout and type size for later
/// sessions.
class HelpWindow : public QWidget {
    Q_OBJECT

  public:
    /// Makes the window; it closes with `owner`.
    HelpWindow(ManualBook book, QWidget* owner);

    /// Shows the window in front, at a place of the manual.
    void open(const ManualPlace& place);
    HelpView& view() const { return *m_view; }
    QLineEdit& search() const { return *m_search; }
    QListWidget& hits() const { return *m_hits; }
    QTreeWidget& contents() const { return *m_contents; }

    /// Shows the place in the manual that was shown when the last session ended; returns false if there is
    /// none.
    bool restorePlace();

  protected:
    void hideEvent(QHideEvent* event) override;

  private:
    QLayout* makeBar();
    void fillContents();
    void addAction(const QString& text, const QList<QKeySequence>& keys, const std::function<void()>& does);
    void find(const QString& typed);
    void addHit(const ManualHit& hit, const QStringList& words);
    void openHit(QListWidgetItem* item);
    void follow(const ManualPlace& place);
    void leave();
    void save() const;

    ManualBook m_book;
    ManualSearch m_sections{m_book};
    QLineEdit* m_search;
    QTreeWidget* m_contents;
    QListWidget* m_hits;
    QStackedWidget* m_side;
    QSplitter* m_parts;
    HelpView* m_view;
    QAction* m_back;
    QAction* m_forward;
};

}  // namespace drillwave
