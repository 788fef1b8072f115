// SPDX-License-Identifier: GPL-3.0-or-later
// One number of the result panel: name, value, and difference from the reference.
#pragma once

#include <QLabel>
#include <QList>
#include <functional>
#include <optional>

#include "core/blow/outputs.h"
#include "ui/job/solved_blow.h"
#include "ui/result/energy_bar.h"
#include "ui/result/feed_text.h"

class QGridLayout;

namespace drillwave {

class SectionBox;

// A value that leads to where it is from, by mouse and keys.

/// Plain text that looks and works like a link.
class PlaceLink : public QLabel {
    Q_OBJECT

  public:
    explicit PlaceLink(QWidget* parent = nullptr);

  signals:
    void followed();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
};

/// Content of a row for a blow.
struct ResultEntry {
    /// Formats the value; empty if there is none.
    using Text = std::function<QString(const SolvedBlow&)>;
    /// The number itself, to be compared; none where it has no sense.
    using Number = std::function<std::optional<double>(const SolvedBlow&, UnitSystem)>;
    /// Formats the difference of the blow on show from the reference.
    using Change = std::function<QString(double now, double then, const SolvedBlow&)>;
    /// Whether it is a number of such a scenario at all; the row is not there otherwise.
    using Concern = std::function<bool(const Scenario&)>;
    /// Whether the text is a warning, and is to look like one.
    using Warning = std::function<bool(const SolvedBlow&)>;
    enum class Weight { usual, heavy };

    QString name = {};  ///< empty: belongs to the row above
    QString meaning;
    Text text;
    std::optional<EnergyPart> part = {};
    Text note = nullptr;  ///< further information on the value of this blow, in its tooltip
    Weight weight = Weight::usual;
    QString objectName = {};
    Number number = nullptr;
    const Output* place = nullptr;  ///< the largest stress whose place the text leads to
    Change change = nullptr;        ///< in percent where there is none
    Warning warning = nullptr;
    Concern concerns = nullptr;      ///< every one where there is none
    const Output* output = nullptr;  ///< whose number it is, where it is that of one
};

/// Its widgets live in the grid of a section: swatch, name, change, value.
class ResultRow {
  public:
    /// Fills the next row of the section's grid.
    ResultRow(ResultEntry entry, SectionBox* section, QGridLayout* grid);

    const ResultEntry& entry() const { return m_entry; }
    SectionBox* section() const { return m_section; }
    /// A PlaceLink where the entry has a place.
    QLabel* value() const { return m_value; }
    bool isThere() const { return !m_value->isHidden(); }
    /// Whether it is there with a value.
    bool isFilled() const;
    /// "section: name<tab>value", with a reference and "<tab>difference".
    QString text() const;

    /// Shows the row only if its entry concerns the scenario.
    void offer(const Scenario& scenario) const;
    void present(const SolvedBlow& blow) const;
    /// Against a reference of that title; nullptr for none.
    void presentChange(const SolvedBlow& blow, const SolvedBlow* reference, const QString& title) const;

  private:
    void place(QGridLayout* grid);
    QString changeText(const SolvedBlow& blow, const SolvedBlow* reference) const;

    ResultEntry m_entry;
    SectionBox* m_section;
    QLabel* m_name;
    QLabel* m_value;
    QLabel* m_change;             // against the reference
    QWidget* m_swatch = nullptr;  // of a part of the energy
};

/// Makes its text selectable; the menu is that of the panel.
void makeSelectable(QLabel& label);

// Entries of the rows of the result panel.

/// Object name of the rows that wait for the study of all gaps.
inline const QString worstName = QStringLiteral("worstNeed");

/// Returns all outputs of a group, in its order; below a largest stress its place as well.
QList<ResultEntry> outputEntries(OutputGroup group);

/// Required and installed feed. `worst` is of the blow on show and must outlive the
/// rows; `worstOf` gives the need of any blow.
QList<ResultEntry> thrustEntries(const WorstNeed& worst, const ResultEntry::Number& worstOf);

/// Returns the hammer energy, the reference of all energy shares where the hammer is followed.
ResultEntry hammerEnergyEntry();

/// The coefficient of restitution, with its error in the tooltip.
ResultEntry corEntry();

}  // namespace drillwave
