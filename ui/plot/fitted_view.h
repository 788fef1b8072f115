// SPDX-License-Identifier: GPL-3.0-or-later
// Fitted until somebody zooms: whether the ranges of a plot's axes are still those that were fitted.
#pragma once

#include <QObject>
#include <functional>

class QCPAxis;

namespace drillwave {

/// Lives as a child of what fits the plot. A view is fitted at first.
class FittedView : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// The range of this axis belongs to the view.
    void watch(const QCPAxis* axis);
    bool isFitted() const { return m_fitted; }
    /// `setRanges` brings everything into view: fitted again.
    void fit(const std::function<void()>& setRanges);
    /// `setRanges` follows what has been chosen: fitted or not as before.
    void adjust(const std::function<void()>& setRanges);
    /// While there is nothing in view, no range of it is anybody's choice.
    void setEmpty(bool empty) { m_empty = empty; }

  signals:
    /// A range was changed otherwise: the view is not fitted any more.
    void chosen();

  private:
    void leave();

    bool m_fitted = true;
    bool m_setting = false;
    bool m_empty = false;
};

}  // namespace drillwave
