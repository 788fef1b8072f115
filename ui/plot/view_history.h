// SPDX-License-Identifier: GPL-3.0-or-later
// The earlier views of a plot, for going back.
#pragma once

#include <qcustomplot.h>

#include <QElapsedTimer>
#include <QPointer>
#include <QString>
#include <QVector>

namespace drillwave {

/// Stack of at most 100 views of a plot: ranges and scales of all axes. Views whose axes had other labels,
/// and so other units, are discarded.
class ViewHistory {
  public:
    explicit ViewHistory(QCustomPlot& plot) : m_plot(plot) {}

    /// Saves the present view. Call this before the view changes.
    void remember();
    /// Saves the view before a burst of changes, such as turns of a wheel. Changes at most half a second
    /// apart count as one step.
    void rememberBurst();
    /// Returns whether a saved view differs from the present one.
    bool canGoBack() const;
    /// Restores the newest saved view that differs from the present one, and removes it and all newer views
    /// from the stack.
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
    QElapsedTimer m_burst;  // time since the last change of a burst; invalid outside a burst
};

}  // namespace drillwave
