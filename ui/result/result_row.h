// SPDX-License-Identifier: GPL-3.0-or-later
// One number of the result panel: name, value, and difference from a reference.
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

// A value that acts as a link to the place it belongs to, for mouse and keys.

/// Label with plain text that looks and works like a link.
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

/// Description of one row of the result panel: how to get its texts and numbers from a blow.
struct ResultEntry {
    /// Function that returns the value as text; empty if there is none.
    using Text = std::function<QString(const SolvedBlow&)>;
    /// Function that returns the number that is compared with that of a reference; nothing if a comparison
    /// has no meaning.
    using Number = std::function<std::optional<double>(const SolvedBlow&, UnitSystem)>;
    /// Function that returns the difference between the number of the blow shown (`now`) and that of the
    /// reference (`then`) as text.
    using Change = std::function<QString(double now, double then, const SolvedBlow&)>;
    /// Function that returns whether the row exists for a scenario; otherwise it is hidden.
    using Concern = std::function<bool(const Scenario&)>;
    /// Function that returns whether the text is a warning, which has a special colour.
    using Warning = std::function<bool(const SolvedBlow&)>;
    enum class Weight { usual, heavy };

    QString name = {};  ///< name of the value; empty if the row continues the row above
    QString meaning;
    Text text;
    /// Part of the energy whose pattern is shown before the name; empty for none.
    std::optional<EnergyPart> part = {};
    Text note = nullptr;  ///< further information on the value, for its tooltip
    Weight weight = Weight::usual;
    QString objectName = {};
    Number number = nullptr;
    const Output* place = nullptr;  ///< output whose place the text links to; nullptr for no link
    Change change = nullptr;        ///< text of the difference; nullptr for a difference in percent
    Warning warning = nullptr;
    Concern concerns = nullptr;      ///< condition for the row; nullptr if every scenario has it
    const Output* output = nullptr;  ///< output that the row shows; nullptr if it shows none
};

/// Row of the result panel. Its widgets are in the grid of a section: pattern, name, difference, value.
class ResultRow {
  public:
    /// Creates the widgets of the entry in the next row of `grid`, the grid of a section.
    ResultRow(ResultEntry entry, SectionBox* section, QGridLayout* grid);

    const ResultEntry& entry() const { return m_entry; }
    SectionBox* section() const { return m_section; }
    /// Returns the label of the value; a PlaceLink if the entry has a place.
    QLabel* value() const { return m_value; }
    /// Returns whether the row is shown.
    bool isThere() const { return !m_value->isHidden(); }
    /// Returns whether the row is shown and has a value.
    bool isFilled() const;
    /// Returns "section: name<tab>value", with "<tab>difference" if there is a reference.
    QString text() const;

    /// Shows the row if its entry exists for the scenario, and hides it otherwise.
    void offer(const Scenario& scenario) const;
    void present(const SolvedBlow& blow) const;
    /// Shows the difference from a reference with this title; nullptr hides it.
    void presentChange(const SolvedBlow& blow, const SolvedBlow* reference, const QString& title) const;

  private:
    void place(QGridLayout* grid);
    QString changeText(const SolvedBlow& blow, const SolvedBlow* reference) const;

    ResultEntry m_entry;
    SectionBox* m_section;
    QLabel* m_name;
    QLabel* m_value;
    QLabel* m_change;             // difference from the reference
    QWidget* m_swatch = nullptr;  // pattern of an energy part
};

/// Lets the user select the text of a label. Its context menu is that of the panel.
void makeSelectable(QLabel& label);

// Entries of the rows of the result panel.

/// Object name of the rows whose values need blows at all gaps (see WorstNeed) and so are shown later.
inline const QString worstName = QStringLiteral("worstNeed");

/// Returns the entries of all outputs of a group in their order. An entry of a largest stress is followed by
/// one for its place.
QList<ResultEntry> outputEntries(OutputGroup group);

/// Returns the entries of required and installed feed force. `worst` is the estimate of all gaps for the blow
/// shown, and must outlive the rows. `worstOf` returns the largest required feed force of any blow.
QList<ResultEntry> thrustEntries(const WorstNeed& worst, const ResultEntry::Number& worstOf);

/// Returns the entry of the hammer energy, to which all energy shares refer if the scenario has a hammer.
ResultEntry hammerEnergyEntry();

/// Returns the entry of the coefficient of restitution, with its error in the tooltip.
ResultEntry corEntry();

}  // namespace drillwave
