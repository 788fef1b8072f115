// SPDX-License-Identifier: GPL-3.0-or-later
// How the gap scatters: all gaps of a period alike, or normally about a mean.
#pragma once

#include <QWidget>
#include <optional>

#include "core/model/scenario.h"
#include "core/study/gap/gap_distribution.h"

class QHBoxLayout;
class QToolButton;

namespace drillwave {

class ChoiceBox;
class QuantityField;

/// Gaps are lengths where the scenario has units, and multiples of d0 where it has none.
class ScatterFields : public QWidget {
    Q_OBJECT

  public:
    explicit ScatterFields(QWidget* parent = nullptr);

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
    QuantityField* addField(const QString& words, const char* name, double ScatterFields::*value);
    QString take(double ScatterFields::*value, double si);
    QString problem() const;
    bool isScattered() const;
    bool isDimensional() const { return m_scenario.form == ScenarioForm::dimensional; }

    Scenario m_scenario;
    double m_d0 = 1;         // in the units of the fields: m, or 1
    double m_mean = 0;       // m, or d0
    double m_deviation = 0;  // m, or d0; 0 before the first choice
    QHBoxLayout* m_layout;
    ChoiceBox* m_choice;
    QWidget* m_fields = nullptr;  // of one quantity for its life
};

}  // namespace drillwave
