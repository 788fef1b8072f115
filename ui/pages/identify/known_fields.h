// SPDX-License-Identifier: GPL-3.0-or-later
// Fields for the tolerances of quantities that a record does not show. Empty fields use assumed tolerances.
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

/// Fields for tolerances (95 %): of the amplifier, of the gauge positions, and of the dimensions of the
/// sections from the gauge to the bit. An empty field shows the assumed tolerance.
class KnownFields : public QWidget {
    Q_OBJECT

  public:
    explicit KnownFields(QWidget* parent = nullptr);

    /// Shows the fields for a gauge at this place. Typed tolerances are kept by their keys.
    void present(const Scenario& scenario, const GaugePlace& place);
    /// Returns the tolerances that the user has typed, for the fields that are shown.
    std::vector<KnownTolerance> known() const;
    /// Puts the focus into the field of a tolerance. Returns false if there is no field with this key.
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
    std::map<std::string, double> m_typed;  // typed tolerances in SI or as a share, by key
};

}  // namespace drillwave
