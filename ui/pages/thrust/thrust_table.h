// SPDX-License-Identifier: GPL-3.0-or-later
// The four needs of the thrust in numbers.
#pragma once

#include <QTableWidget>

#include "ui/pages/thrust/thrust_picture.h"

namespace drillwave {

/// A column for each need, and rows of what is known of it.
class ThrustTable : public QTableWidget {
    Q_OBJECT

  public:
    explicit ThrustTable(QWidget* parent = nullptr);

    /// Shows the present scenario; a need that is not known has no column.
    void present(const FeedEstimate& feed, const ThrustUnits& units);
    void clearNumbers();

    QSize sizeHint() const override;
    /// Two rows; the others are scrolled to.
    QSize minimumSizeHint() const override;

  private:
    int heightOf(int contents) const;
    void setText(int row, ThrustCase which, const QString& text, const QString& more = {});
};

}  // namespace drillwave
