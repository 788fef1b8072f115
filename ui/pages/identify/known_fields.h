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

/// Fields for tolerances (95 %) that the identification of the rock uses. They are those of the amplifier,
/// the gauge positions, and the dimensions of the sections from gauge to bit. An empty field shows the
/// assumed tolerance.
class KnownFields : public QWidget {
    Q_OBJECT

  public:
    explicit KnownFields(QWidget* parent = nullptr);

    /// Shows the fields for the tolerances that matter if the strain gauge is at `place`. A tolerance that
    /// was typed earlier appears again with its field.
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
