// SPDX-License-Identifier: GPL-3.0-or-later
// Fields for values that a study needs and the scenario lacks.
#pragma once

#include <QWidget>
#include <string_view>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/scenario.h"

class QLabel;

namespace drillwave {

class QuantityField;
class UnitChoice;

/// A field for each of some optional parameters, shown while the scenario might have it and does not.
class MissingFields : public QWidget {
    Q_OBJECT

  public:
    /// The units must outlive it.
    MissingFields(const std::vector<std::string_view>& keys, const UnitChoice& units,
                  QWidget* parent = nullptr);

    void present(const Scenario& scenario);

  signals:
    /// The user has entered a value (SI) to the end.
    void entered(const drillwave::KeptParameter& parameter, double si);

  private:
    struct Field {
        KeptParameter parameter;
        QLabel* label;
        QuantityField* field;
        QWidget* unit;
    };
    std::vector<Field> m_fields;
};

}  // namespace drillwave
