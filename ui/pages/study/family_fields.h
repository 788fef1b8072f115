// SPDX-License-Identifier: GPL-3.0-or-later
// Controls for a second parameter of a study and its values, each of which gives one curve.
#pragma once

#include <QWidget>
#include <string_view>

#include "ui/pages/study/study_range.h"

class QLineEdit;

namespace drillwave {

class ChoiceBox;
class UnitChoice;

/// Controls for a family of curves: a list of parameters (or none) and a field for their values. Values are
/// typed as "0.01; 0.1; 1" or "3 m; 12 ft". Invalid text stays, is marked with its reason, and changes
/// nothing.
class FamilyFields : public QWidget {
    Q_OBJECT

  public:
    /// Largest number of values, each of which gives one curve, so that the curves can be distinguished.
    static constexpr std::size_t mostValues = 12;

    /// Creates the controls with the label `words`. They first show the first family of `preferred` (values
    /// in SI) whose parameter applies. The units must outlive the object.
    FamilyFields(const QString& words, std::vector<StudyFamily> preferred, const UnitChoice& units,
                 QWidget* parent = nullptr);

    /// Lists the parameters of the scenario. The user chooses the one that differs from curve to curve. Emits
    /// changed() if the family has changed.
    void present(const Scenario& scenario);
    const StudyFamily& family() const { return m_family; }
    void setFamily(const StudyFamily& family);
    /// Returns why the text is not a list of values; empty if it is.
    const QString& problem() const { return m_problem; }

  signals:
    /// Reports that family() has changed.
    void changed();

  private:
    void choose();
    void read();
    void showValues();

    std::vector<StudyFamily> m_preferred;
    const UnitChoice& m_units;
    Scenario m_scenario;
    StudyFamily m_family;
    bool m_chosen = false;  // whether the parameter was chosen, by the user or as the first one
    QString m_problem;
    ChoiceBox* m_parameters;
    QLineEdit* m_values;
};

}  // namespace drillwave
