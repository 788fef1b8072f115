// SPDX-License-Identifier: GPL-3.0-or-later
// A field for the section of the rod that all pages observe.
#pragma once

#include <QDoubleSpinBox>

#include "ui/job/observation.h"

namespace drillwave {

/// Field for the observed section, x/L. It shows three decimals and keeps all digits.
class PlaceField : public QDoubleSpinBox {
    Q_OBJECT

  public:
    /// Creates the field. `observation` (observed section and time of all pages) must outlive it.
    PlaceField(Observation& observation, const QString& toolTip, QWidget* parent);
};

}  // namespace drillwave
