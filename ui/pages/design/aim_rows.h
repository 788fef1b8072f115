// SPDX-License-Identifier: GPL-3.0-or-later
// Objectives of the Design study, each a sentence made of list boxes.
#pragma once

#include <QWidget>
#include <vector>

#include "core/study/design/design_study.h"
#include "ui/pages/design/row_list.h"

namespace drillwave {

class ChoiceBox;
class OutputBox;

/// Row of controls for one objective of a design study, such as the largest mean of the efficiency.
class AimRow : public QWidget {
    Q_OBJECT

  public:
    /// Creates a row that begins with `words`, such as "for the".
    AimRow(const QString& words, QWidget* parent);
    /// Fills the list box of the objective with the results that the scenario has.
    void present(const Scenario& scenario);
    /// Returns the objective that the row shows.
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

/// Controls for one to three objectives of a design study; the first one decides which design is best. They
/// show default objectives until the user changes them, and again if the scenario lacks a chosen result.
class AimRows : public QWidget {
    Q_OBJECT

  public:
    explicit AimRows(QWidget* parent);
    /// Offers the results of the scenario as objectives. Keeps the chosen objectives if the scenario has all
    /// of them.
    void present(const Scenario& scenario);
    /// Discards the choice, because the next scenario belongs to another document: present() then shows the
    /// defaults.
    void forget() { m_isChosen = false; }
    /// Returns the objectives of the design study. The first one decides which design is best; the others are
    /// reported for comparison.
    std::vector<DesignAim> aims() const;
    const std::vector<AimRow*>& rows() const { return m_rows.rows(); }
    void setAims(const std::vector<DesignAim>& aims);

  signals:
    void changed();

  private:
    void append(const DesignAim& aim);

    Scenario m_scenario;
    bool m_isChosen = false;  // whether the user has chosen the objectives
    QVBoxLayout* m_layout;
    QToolButton* m_add;
    RowList<AimRow> m_rows;  // rows in m_layout
};

}  // namespace drillwave
