// SPDX-License-Identifier: GPL-3.0-or-later
// The tabs of the pages in one row, with the name of each group before its tabs.
#pragma once

#include <QTabBar>

class QWidget;

namespace drillwave {

/// A caption is a tab that cannot be chosen. If the row is too short the captions shrink to a gap, then tabs
/// are scrolled; the chosen one is always in view, and the name of a tab at the edge ends in an ellipsis.
class TabStrip : public QTabBar {
    Q_OBJECT

  public:
    explicit TabStrip(QWidget* parent = nullptr);

    /// Insert a caption or a tab before the tab at `index`.
    void insertCaption(int index, const QString& text);
    void insertPage(int index, QWidget* page, const QString& title);
    /// nullptr for a caption, and where there is no tab.
    QWidget* pageAt(int index) const;
    /// Changes the title of the tab at `index`.
    void rename(int index, const QString& title);
    /// Sets whether a page can be chosen; otherwise its tab shows `why`, or is hidden if that is
    /// empty.
    void setOffered(int index, bool offered, const QString& why);
    int indexOf(const QWidget* page) const;
    /// Chooses the tab `step` tabs of pages further on, round the row.
    void choose(int step);

  signals:
    /// A click on the tab of a page that cannot be chosen.
    void refused(QWidget* page);

  protected:
    QSize tabSizeHint(int index) const override;
    QSize minimumTabSizeHint(int index) const override;
    void initStyleOption(QStyleOptionTab* option, int index) const override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

  private:
    bool isCaption(int index) const { return !pageAt(index); }
    int captionWidth(int index) const;
    bool hasRoomForCaptions() const;
    QRect shownRect() const;
};

}  // namespace drillwave
