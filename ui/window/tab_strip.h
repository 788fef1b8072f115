// SPDX-License-Identifier: GPL-3.0-or-later
// Row of tabs for the pages, with the name of each group before its tabs.
#pragma once

#include <QTabBar>

class QWidget;

namespace drillwave {

/// Row of tabs of the pages. A caption is a tab with the name of a group of pages, which cannot be chosen. If
/// the row is too short, captions shrink to a gap, then letters become a little smaller, and then the tabs
/// scroll. The chosen tab is always visible, and a name cut off at the edge ends in an ellipsis.
class TabStrip : public QTabBar {
    Q_OBJECT

  public:
    explicit TabStrip(QWidget* parent = nullptr);

    /// Inserts a caption, the name of a group of pages, before the tab at `index`.
    void insertCaption(int index, const QString& text);
    void insertPage(int index, QWidget* page, const QString& title);
    /// Returns the page that belongs to the tab at `index`. nullptr for a caption (name of a group of pages),
    /// or if there is no such tab.
    QWidget* pageAt(int index) const;
    /// Changes the title of the tab at `index`.
    void rename(int index, const QString& title);
    /// Sets whether the page of the tab at `index` can be chosen. If not, the tab has `why` in its tooltip;
    /// it is hidden if `why` is empty.
    void setOffered(int index, bool offered, const QString& why);
    int indexOf(const QWidget* page) const;
    /// Chooses the next tab to the right (step 1) or to the left (step −1), skipping captions and pages that
    /// cannot be chosen. At the end of the row it continues at the other end.
    void choose(int step);

  signals:
    /// Emitted when the user clicks the tab of a page that cannot be chosen for the present scenario.
    void refused(QWidget* page);

  protected:
    QSize tabSizeHint(int index) const override;
    QSize minimumTabSizeHint(int index) const override;
    void initStyleOption(QStyleOptionTab* option, int index) const override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void tabLayoutChange() override;

  private:
    bool isCaption(int index) const { return !pageAt(index); }
    int captionWidth(int index) const;
    bool hasRoomForCaptions() const;
    QRect shownRect() const;
    void fitLetters();

    bool m_isFitting = false;
};

}  // namespace drillwave
