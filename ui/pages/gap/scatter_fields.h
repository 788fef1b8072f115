// SPDX-License-Identifier: GPL-3.0-or-later
// How the gap scatters: all gaps of a period alike, or normally about a mean.
#pragma once

#include <QWidget>
#include <optional>

#include "core/model/scenario.h"
#include "core/study/gap/gap_distribution.h"

namespace drillwave {

class ChoiceBox;
class QuantityField;
class UnitChoice;

/// Gaps are lengths where the scenario has units, and multiples of d0 where it has none.
class ScatterFields : public QWidget {
    Q_OBJECT

  public:
    /// The units must outlive it.
    ScatterFields(const UnitChoice& units, QWidget* parent);

    /// The fields of mean and deviation, beside this, shown where they say something: siblings of it, so that
    /// a row of controls can wrap between them.
    QList<QWidget*> fields() const { return {m_meanBox, m_deviationBox}; }

    /// Takes over whether there are units, and what d0 is.
    void present(const Scenario& scenario);
    /// What is chosen, for the scenario shown; nothing for all gaps alike.
    std::optional<NormalGap> normal() const;
    /// The same for the command line: "--gap-mean", "1 mm", "--gap-deviation", "0.2 mm"; nothing for all
    /// alike.
    QStringList commandWords() const;
  signals:
    /// normal() is another one.
    void changed();

  private:
    void choose();
    void addFields();
    QuantityField* addField(QWidget* box, const QString& words, const char* name,
                            double ScatterFields::*value);
    QString take(double ScatterFields::*value, double si);
    QString problem() const;
    bool isScattered() const;
    bool isDimensional() const { return m_scenario.form == ScenarioForm::dimensional; }

    const UnitChoice& m_units;
    Scenario m_scenario;
    double m_d0 = 1;         // in the units of the fields: m, or 1
    double m_mean = 0;       // m, or d0
    double m_deviation = 0;  // m, or d0; 0 before the first choice
    ChoiceBox* m_choice;
    QWidget* m_meanBox;
    QWidget* m_deviationBox;
};

}  // namespace drillwave
