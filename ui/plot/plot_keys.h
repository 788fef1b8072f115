// SPDX-License-Identifier: GPL-3.0-or-later
// Keyboard control of a plot.
#pragma once

#include <QObject>

class QKeyEvent;

namespace drillwave {

class PlotWidget;

/// Handler of the keys of one plot, which are listed in the comment of PlotWidget. The plot owns the object.
class PlotKeys : public QObject {
    Q_OBJECT

  public:
    explicit PlotKeys(PlotWidget& plot);

    /// Executes the command of a key. Returns false if the key has no meaning in the plot.
    bool press(const QKeyEvent& event);
    /// Reports whether the mouse pointer is over the plot (`isHere`). While it is, Backspace, A, B and T act
    /// on the plot even if another widget has the focus.
    void followPointer(bool isHere);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool pointKey(const QKeyEvent& event);
    bool cursorKey(const QKeyEvent& event);
    bool viewKey(const QKeyEvent& event);
    bool arrowKey(int key);

    PlotWidget& m_plot;
};

}  // namespace drillwave
