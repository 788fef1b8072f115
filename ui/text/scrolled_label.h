// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences that shrink and scroll to leave room below them.
#pragma once

#include <QScrollArea>

class QLabel;

namespace drillwave {

/// A label as high as its words where that is not more than a share of the window's height; longer ones are
/// scrolled in that room, which is of two lines at least.
class ScrolledLabel : public QScrollArea {
    Q_OBJECT

  public:
    /// `label` should wrap; it becomes the child.
    ScrolledLabel(QLabel* label, double shareOfWindow, QWidget* parent);

    /// Sets the text of the label; its room is there as soon as the layout around is activated.
    void setText(const QString& text);
    QString text() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

  protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QLabel* m_label;
    double m_share;
};

}  // namespace drillwave
