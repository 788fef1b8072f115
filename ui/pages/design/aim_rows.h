// SPDX-License-Identifier: GPL-3.0-or-later
// Objectives of a design, as a sentence made of boxes.
#pragma once

#include <QWidget>
#include <vector>

#include "core/study/design/design_study.h"
#include "ui/pages/design/row_list.h"

namespace drillwave {

class ChoiceBox;
class OutputBox;

/// Describes a statistic of an output to be maximised or minimised: "in the worst 5 %", "on average".
QString statisticWords(const Statistic& statistic, Sense sense);

/// One aim: largest or least, of which result, by which statistic.
class AimRow : public QWidget {
    Q_OBJECT

  public:
    AimRow(const QString& words, QWidget* parent);
    void present(const Scenario& scenario);
    DesignAim aim() const;
    void setAim(const DesignAim& aim);
    void setRemovable(bool removable);

  signals:
    void changed();
    void removed();

  private:
    void nameStatistics();

    ChoiceBox* m_sense;
    OutputBox* m_output;
    ChoiceBox* m_statistic;
    QToolButton* m_remove;
};

/// One to three objectives; the first decides. Shows the defaults until the user chooses, and again if the
/// scenario does not have what was chosen.
class AimRows : public QWidget {
    Q_OBJECT

  public:
    explicit AimRows(QWidget* parent);
    /// Offers the results that the scenario has.
    void present(const Scenario& scenario);
    /// The scenario that is presented next is another document: what was chosen of this one is of no concern.
    void forget() { m_isChosen = false; }
    std::vector<DesignAim> aims() const;
    const std::vector<AimRow*>& rows() const { return m_rows.rows(); }
    void setAims(const std::vector<DesignAim>& aims);

  signals:
    void changed();

  private:
    void append(const DesignAim& aim);

    Scenario m_scenario;
    bool m_isChosen = false;  // by the user
    QVBoxLayout* m_layout;
    QToolButton* m_add;
    RowList<AimRow> m_rows;  // in those
};

}  // namespace drillwave
