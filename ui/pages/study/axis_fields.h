// SPDX-License-Identifier: GPL-3.0-or-later
// Controls of one axis of a study: parameter, start, end and steps.
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

/// A box of the parameters that apply to the scenario, fields for both ends, and linear or logarithmic. Text
/// that is no value, and ends that are equal, stay in the fields, marked, and change nothing.
class AxisFields : public QWidget {
    Q_OBJECT

  public:
    /// `words` is the label ("vary"). The first key of `preferred` that applies to a scenario is selected
    /// until the user selects one. The units must outlive it.
    AxisFields(const QString& words, std::vector<std::string_view> preferred, const UnitChoice& units,
               QWidget* parent = nullptr, StudyOf of = StudyOf::oneBlow);

    /// Offers what applies to the scenario; takes a first choice, with a range around its value, or another
    /// one where the last does not apply any more. Tells changed() where the range has changed.
    void present(const Scenario& scenario);
    /// Without a parameter before the first scenario.
    const StudyRange& range() const { return m_range; }
    /// Shows that range, and tells changed() where it is another one.
    void setRange(const StudyRange& range);
    /// Whether the controls say a range that can be used.
    bool isValid() const;

  signals:
    /// range() is another one.
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
    QWidget* m_startPart;  // where the fields are, another one for each parameter
    QWidget* m_stopPart;
    QuantityField* m_start = nullptr;
    QuantityField* m_stop = nullptr;
    QCheckBox* m_logarithmic;
};

}  // namespace drillwave
