// SPDX-License-Identifier: GPL-3.0-or-later
// Tracks whether the axis ranges of a plot are still the fitted ones or have been changed by the user.
#pragma once

#include <QObject>
#include <functional>

class QCPAxis;

namespace drillwave {

/// Record of whether a plot shows all of its contents. This is so at first and after fit(), until the user
/// zooms or pans, that is, changes a watched range. The parent object owns it.
class FittedView : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// Adds an axis. From now on, a change of its range by other means than fit() or adjust() counts as
    /// zooming or panning by the user.
    void watch(const QCPAxis* axis);
    /// Returns whether the axis ranges are still those that fit() has set. False after the user has zoomed or
    /// panned; ranges set in adjust() do not count.
    bool isFitted() const { return m_fitted; }
    /// Calls `setRanges`, which must bring everything into view. isFitted() is then true.
    void fit(const std::function<void()>& setRanges);
    /// Calls `setRanges`, which may change the ranges of the axes. The result of isFitted() stays as it is.
    void adjust(const std::function<void()>& setRanges);
    /// Sets whether the plot shows nothing. Range changes of an empty plot do not count as zooming by the
    /// user.
    void setEmpty(bool empty) { m_empty = empty; }

  signals:
    /// Reports that the user has zoomed or panned, that is, that a range was changed by other means than
    /// fit() or adjust().
    void chosen();

  private:
    void leave();

    bool m_fitted = true;
    bool m_setting = false;
    bool m_empty = false;
};

}  // namespace drillwave
