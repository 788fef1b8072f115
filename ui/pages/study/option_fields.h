// SPDX-License-Identifier: GPL-3.0-or-later
// The controls of a study's options, and their values as arguments of the command.
#pragma once

#include <QHash>
#include <QObject>
#include <QWidget>
#include <map>

#include "core/report/study.h"

namespace drillwave {

class AxisFields;
class ChoiceBox;
class QuantityField;
class UnitChoice;

/// Controls for the options of a study. Invalid text, or text that the study refuses, stays in its field, is
/// marked with the reason, and changes nothing. The page owns the object.
class OptionFields : public QObject {
    Q_OBJECT

  public:
    /// Creates the controls. Study and units must outlive the object.
    OptionFields(const Study& study, const UnitChoice& units, QWidget* page);

    /// Returns the controls in their order from left to right. The page places them in a row that wraps.
    const QList<QWidget*>& widgets() const { return m_widgets; }
    /// Offers the choices that the scenario permits. Proposes new values if the form of the scenario (uniform
    /// rod, drill string, dimensionless) has changed.
    void present(const Scenario& scenario);
    /// Returns the options that the controls describe, as values by the key of the option.
    StudyWords words() const;

  signals:
    /// Reports that words() has changed.
    void changed();

  private:
    /// Option with a number and a unit. The value is in SI, or dimensionless for scenarios without units.
    struct Quantified {
        const StudyOption* option;
        const QuantityControl* control;
        QWidget* box;
        double value = 0;
        QuantityField* field = nullptr;
    };

    ChoiceBox* groupBox(const StudyGroup& group, QWidget* page);
    bool isGiven(const StudyOption& option) const;
    Quantity quantityOf(const QuantityControl& control) const;
    const Unit& unitOf(const QuantityControl& control) const;
    void propose();
    void addField(Quantified& quantified);
    void showFields();
    QString take(Quantified& quantified, double value);

    const Study& m_study;
    const UnitChoice& m_units;
    Scenario m_scenario;
    QList<QWidget*> m_widgets;
    std::map<const StudyGroup*, ChoiceBox*> m_groups;
    std::vector<Quantified> m_quantities;
    std::vector<std::pair<const StudyOption*, AxisFields*>> m_ranges;
};

}  // namespace drillwave
