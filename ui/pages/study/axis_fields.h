// SPDX-License-Identifier: GPL-3.0-or-later
// Controls for one axis of a study: parameter, ends of its range, and linear or logarithmic steps.
#pragma once

#include <QWidget>
#include <string_view>
#include <vector>

#include "ui/pages/study/parameter_names.h"
#include "ui/pages/study/study_range.h"

class QCheckBox;

namespace drillwave {

class ChoiceBox;
class QuantityField;
class UnitChoice;

/// Controls for the range of a parameter: a list of the scenario's parameters, fields for both ends, and a
/// choice of linear or logarithmic. Invalid text and equal ends stay in the fields, are marked, and change
/// nothing.
class AxisFields : public QWidget {
    Q_OBJECT

  public:
    /// Creates the controls with the label `words`, such as "vary". At first, the first parameter key of
    /// `preferred` that applies to the scenario is selected. The units must outlive the object.
    AxisFields(const QString& words, std::vector<std::string_view> preferred, const UnitChoice& units,
               QWidget* parent = nullptr, StudyOf of = StudyOf::oneBlow);

    /// Lists the parameters of the scenario, for the user to choose from. If none is selected that applies to
    /// the scenario, it selects one, with a range around its value. Emits changed() if the range has changed.
    void present(const Scenario& scenario);
    /// Returns the range; before the first scenario it has no parameter.
    const StudyRange& range() const { return m_range; }
    /// Shows a range in the fields. Emits changed() if it differs from the present one.
    void setRange(const StudyRange& range);
    /// Returns whether the controls describe a valid range.
    bool isValid() const;

  signals:
    /// Reports that range() has changed.
    void changed();

  private:
    void widen();
    void choose();
    void addFields();
    QuantityField* addField(QWidget& part, const QString& words, const QString& name,
                            double StudyRange::*end);
    QString take(double StudyRange::*end, double si);

    std::vector<std::string_view> m_preferred;
    StudyOf m_of;
    QString m_words;
    const UnitChoice& m_units;
    Scenario m_scenario;
    StudyRange m_range;
    ChoiceBox* m_parameters;
    QWidget* m_startPart;  // holder of the start field, which is replaced for each parameter
    QWidget* m_stopPart;
    QuantityField* m_start = nullptr;
    QuantityField* m_stop = nullptr;
    QCheckBox* m_logarithmic;
};

}  // namespace drillwave
