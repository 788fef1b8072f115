// SPDX-License-Identifier: GPL-3.0-or-later
// Fields for values that a study needs and the scenario does not have.
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

/// Fields for parameters that a study needs but a scenario may lack. A field is shown while its parameter
/// applies to the scenario but has no value.
class MissingFields : public QWidget {
    Q_OBJECT

  public:
    /// Creates a field for each parameter key, such as "drill.thrust". The units must outlive the object.
    MissingFields(const std::vector<std::string_view>& keys, const UnitChoice& units,
                  QWidget* parent = nullptr);

    void present(const Scenario& scenario);

  signals:
    /// Reports that the user has entered a value (in SI) for a parameter.
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
