// SPDX-License-Identifier: GPL-3.0-or-later
// Tracks whether the axis ranges of a plot are still the fitted ones or have been changed by the user.
#pragma once

#include <QObject>
#include <functional>

class QCPAxis;

namespace drillwave {

/// Record of whether a view is fitted to its contents. A view is fitted at first, and until a watched range
/// changes by other means than fit() or adjust(). The parent object owns it.
class FittedView : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// Adds an axis to the view: from now on its range changes count.
    void watch(const QCPAxis* axis);
    /// Returns whether no watched range has been changed by other means since the last fit().
    bool isFitted() const { return m_fitted; }
    /// Calls `setRanges`, which brings everything into view, and marks the view as fitted.
    void fit(const std::function<void()>& setRanges);
    /// Calls `setRanges` without changing whether the view is fitted.
    void adjust(const std::function<void()>& setRanges);
    /// Sets whether the view is empty. Range changes of an empty view do not count as choices of the user.
    void setEmpty(bool empty) { m_empty = empty; }

  signals:
    /// Reports that a range was changed by other means than fit() or adjust(), so that the view is no longer
    /// fitted.
    void chosen();

  private:
    void leave();

    bool m_fitted = true;
    bool m_setting = false;
    bool m_empty = false;
};

}  // namespace drillwave
