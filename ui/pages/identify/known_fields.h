// SPDX-License-Identifier: GPL-3.0-or-later
// Tolerances of what a record does not show: assumed until they are typed.
#pragma once

#include <QWidget>
#include <map>
#include <string>
#include <vector>

#include "core/study/identify/gauge_place.h"
#include "core/study/identify/identify_question.h"

namespace drillwave {

class FlowLayout;
class QuantityField;
struct AssumedTolerance;

/// A field for the amplifier, the place of the gauges and each size of gauge's section and of the sections
/// towards the bit. An empty field shows what is assumed.
class KnownFields : public QWidget {
    Q_OBJECT

  public:
    explicit KnownFields(QWidget* parent = nullptr);

    /// Shows the fields for a gauge there; what was typed stays with its key.
    void present(const Scenario& scenario, const GaugePlace& place);
    /// Returns the tolerances typed, of the fields that are shown.
    std::vector<KnownTolerance> known() const;
    /// Puts the cursor into a field; false where there is none of that key.
    bool goTo(const std::string& key);

  signals:
    void changed();

  private:
    struct Field {
        std::string key;
        QuantityField* field = nullptr;
    };
    void rebuild(const Scenario& scenario, const std::vector<AssumedTolerance>& rows);

    FlowLayout* m_layout;
    std::vector<Field> m_fields;
    std::map<std::string, double> m_typed;  // by key
};

}  // namespace drillwave
