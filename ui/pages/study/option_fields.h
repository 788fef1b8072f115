// SPDX-License-Identifier: GPL-3.0-or-later
// The controls of a study's options, and the words of a command line that say the same.
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

/// One control for each option that has one, by the kind of its control. Text that is no value, or that the
/// study refuses, stays in its field, marked with the reason, and changes nothing. Lives as a child of the
/// page.
class OptionFields : public QObject {
    Q_OBJECT

  public:
    /// Study and units must outlive it.
    OptionFields(const Study& study, const UnitChoice& units, QWidget* page);

    /// The controls in their order, for a row that wraps.
    const QList<QWidget*>& widgets() const { return m_widgets; }
    /// Offers what applies to the scenario; proposes new values where its form is another one.
    void present(const Scenario& scenario);
    /// The options as the controls give them, for the scenario shown.
    StudyWords words() const;

  signals:
    /// words() are others.
    void changed();

  private:
    /// A number with a unit: its value is in SI, or a mere number where the scenario has no units.
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
