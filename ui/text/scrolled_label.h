// SPDX-License-Identifier: GPL-3.0-or-later
// Text that scrolls if it would take too much room.
#pragma once

#include <QScrollArea>

class QLabel;

namespace drillwave {

/// Label as high as its text, but at most a share of the window's height, and at least two lines. Longer text
/// is scrolled.
class ScrolledLabel : public QScrollArea {
    Q_OBJECT

  public:
    /// Takes a label, which becomes a child and should wrap its text. `shareOfWindow` is the largest share of
    /// the window's height, 0 … 1.
    ScrolledLabel(QLabel* label, double shareOfWindow, QWidget* parent);

    /// Sets the text of the label. The new height applies when the surrounding layout is activated.
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
