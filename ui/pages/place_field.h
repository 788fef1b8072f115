// SPDX-License-Identifier: GPL-3.0-or-later
// The section of the rod that all pages look at, as a field.
#pragma once

#include <QDoubleSpinBox>

#include "ui/job/observation.h"

namespace drillwave {

/// x/L of the observation, shown with three decimals, kept with all.
class PlaceField : public QDoubleSpinBox {
    Q_OBJECT

  public:
    /// The observation must outlive the field.
    PlaceField(Observation& observation, const QString& toolTip, QWidget* parent);
};

}  // namespace drillwave
