// SPDX-License-Identifier: GPL-3.0-or-later
// A second parameter and the values it takes: one curve each.
#pragma once

#include <QWidget>
#include <string_view>

#include "ui/pages/study/study_range.h"

class QLineEdit;

namespace drillwave {

class ChoiceBox;
class UnitChoice;

/// A box with the parameters that apply, or none, and a line for values, "0.01; 0.1; 1" or "3 m; 12 ft". Text
/// that is no list of values stays, marked with the reason, and changes nothing.
class FamilyFields : public QWidget {
    Q_OBJECT

  public:
    /// Most values of a family, so that curves can be distinguished.
    static constexpr std::size_t mostValues = 12;

    /// Begins with these values of the first of these keys that applies; in SI. The units must outlive it.
    FamilyFields(const QString& words, std::vector<StudyFamily> preferred, const UnitChoice& units,
                 QWidget* parent = nullptr);

    /// Offers what applies to the scenario. Tells changed() where the family has changed.
    void present(const Scenario& scenario);
    const StudyFamily& family() const { return m_family; }
    void setFamily(const StudyFamily& family);
    /// Why the text is no list of values; empty when it is.
    const QString& problem() const { return m_problem; }

  signals:
    /// family() is another one.
    void changed();

  private:
    void choose();
    void read();
    void showValues();

    std::vector<StudyFamily> m_preferred;
    const UnitChoice& m_units;
    Scenario m_scenario;
    StudyFamily m_family;
    bool m_chosen = false;  // the user's, or the first
    QString m_problem;
    ChoiceBox* m_parameters;
    QLineEdit* m_values;
};

}  // namespace drillwave
