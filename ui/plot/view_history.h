// SPDX-License-Identifier: GPL-3.0-or-later
// The views of a plot one after the other, to go back to.
#pragma once

#include <qcustomplot.h>

#include <QElapsedTimer>
#include <QPointer>
#include <QString>
#include <QVector>

namespace drillwave {

/// Ranges and scales of all axes. Views of other units (axes of other labels) are forgotten.
class ViewHistory {
  public:
    explicit ViewHistory(QCustomPlot& plot) : m_plot(plot) {}

    /// Keeps the present view; call before it changes.
    void remember();
    /// Remembers the view before a burst of changes, for example by a wheel: changes half a second or less
    /// apart are one step.
    void rememberBurst();
    bool canGoBack() const;
    /// Restores the last view that differs from the present one.
    void goBack();

  private:
    struct AxisState {
        QPointer<QCPAxis> axis;
        QCPRange range;
        QCPAxis::ScaleType scale = QCPAxis::stLinear;
        QString label;
    };
    using View = QVector<AxisState>;
    View present() const;
    static bool isStale(const View& view);
    static bool isShown(const View& view);

    QCustomPlot& m_plot;
    QVector<View> m_views;
    QElapsedTimer m_burst;  // since its last change; invalid outside of a burst
};

}  // namespace drillwave
