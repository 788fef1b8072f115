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

/// Label with plain text that looks and works like a link: a click, Enter or Space emits followed().
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
    /// Function that returns the value of the row for a solved blow as text with unit, such as "12.3 kN". The
    /// text is empty if the blow has no such value.
    using Text = std::function<QString(const SolvedBlow&)>;
    /// Function that returns the value of the row as a number in this system of units, for comparing it with
    /// that of a reference blow. Nothing if a comparison has no meaning.
    using Number = std::function<std::optional<double>(const SolvedBlow&, UnitSystem)>;
    /// Function that returns as text by how much the row's value `now` (blow shown) differs from the value
    /// `then` (reference blow).
    using Change = std::function<QString(double now, double then, const SolvedBlow&)>;
    /// Function that returns whether the row applies to a scenario; if not, the row is hidden.
    using Concern = std::function<bool(const Scenario&)>;
    /// Function that returns whether the text of the row is a warning, such as a feed force that is too
    /// small. Warnings have a special colour.
    using Warning = std::function<bool(const SolvedBlow&)>;
    enum class Weight { usual, heavy };

    QString name = {};  ///< name of the value; empty if the row continues the row above
    QString meaning;
    Text text;
    /// Part of the energy that the value belongs to. Its pattern in the energy bar is then shown before the
    /// name. Empty if the value belongs to none.
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

/// Row of the result panel, which belongs to a section. From left to right it has the pattern of an energy
/// part, the name, the difference from a reference, and the value.
class ResultRow {
  public:
    /// Creates the widgets of the row described by `entry`, and adds them to the next row of `grid`, the grid
    /// of `section`.
    ResultRow(ResultEntry entry, SectionBox* section, QGridLayout* grid);

    const ResultEntry& entry() const { return m_entry; }
    SectionBox* section() const { return m_section; }
    /// Returns the label of the value. It is a link (PlaceLink) if the value has a place and time in the
    /// string, otherwise plain text.
    QLabel* value() const { return m_value; }
    /// Returns whether the row is shown; rows that do not apply to the scenario are hidden.
    bool isThere() const { return !m_value->isHidden(); }
    /// Returns whether the row is shown and contains a value, not only a dash.
    bool isFilled() const;
    /// Returns the row as a line of text, "section: name<tab>value". "<tab>difference" follows if the value
    /// is compared with that of a reference blow.
    QString text() const;

    /// Shows the row if it applies to the scenario, and hides it otherwise.
    void offer(const Scenario& scenario) const;
    void present(const SolvedBlow& blow) const;
    /// Shows how the value of `blow` differs from that of the blow `reference`, which is called `title` in
    /// the tooltip. Hides the difference if `reference` is nullptr.
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

/// Lets the user select and copy the text of a label. A right click on it opens the menu of the widget that
/// contains the label.
void makeSelectable(QLabel& label);

// Entries of the rows of the result panel.

/// Object name of the rows that depend on the blows at all gaps between bit and rock (see WorstNeed). Their
/// values appear later than the others.
inline const QString worstName = QStringLiteral("worstNeed");

/// Returns the descriptions of the rows for all results of a group, such as the stresses, in the order in
/// which they are shown. After the row of a largest stress, another row states where and when it occurs.
QList<ResultEntry> outputEntries(OutputGroup group);

/// Returns the descriptions of the rows on required and installed feed force. `worst` is the estimate for all
/// gaps between bit and rock for the blow shown; it must outlive the rows. `worstOf` returns the largest
/// required feed force of any blow.
QList<ResultEntry> thrustEntries(const WorstNeed& worst, const ResultEntry::Number& worstOf);

/// Returns the description of the row with the hammer energy. If the scenario has a hammer, all energy shares
/// are relative to this value.
ResultEntry hammerEnergyEntry();

/// Returns the description of the row with the coefficient of restitution; the tooltip of the row states its
/// numerical error.
ResultEntry corEntry();

}  // namespace drillwave
