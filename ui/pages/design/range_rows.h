// SPDX-License-Identifier: GPL-3.0-or-later
// Ranges of several parameters, one below the other: those that are uncertain, and those that are chosen.
#pragma once

#include <QWidget>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/pages/design/row_list.h"
#include "ui/pages/study/study_range.h"

class QCheckBox;
class QSpinBox;

namespace drillwave {

class ChoiceBox;
class DensityMark;
class QuantityField;
class UnitChoice;

/// Use of the ranges.
enum class RangeUse { uncertain, chosen };

/// One range with its distribution, or with the number of values to try. Text that is no value stays in its
/// field, marked, and changes nothing.
class RangeRow : public QWidget {
    Q_OBJECT

  public:
    /// The units must outlive it.
    RangeRow(RangeUse use, const UnitChoice& units, QWidget* parent);

    /// Offers the parameters that apply to the scenario. One just chosen gets half to 1.5 times its value.
    void present(const Scenario& scenario);
    const StudyRange& range() const { return m_range; }
    void setRange(const StudyRange& range);
    /// The words of the command line: "bit_rock.gamma=0.05:0.3:normal", "pulse.duration=100 us:400 us:11".
    std::string text() const;
    /// Sets the controls by a text as of the command. Returns false and changes nothing if they cannot show
    /// it.
    bool setText(const std::string& text);
    /// Returns why the text in a field is wrong, with the field's name; empty if all are right.
    QString problem() const;
    void setRemovable(bool removable);

  signals:
    /// text() or problem() is another one.
    void changed();
    void removed();

  private:
    void addKind();
    void addCount();
    void choose();
    void addFields();
    QuantityField* addField(double StudyRange::*end, const QString& name, const QString& words);
    QString take(double StudyRange::*end, double si);
    void follow();

    RangeUse m_use;
    const UnitChoice& m_units;
    Scenario m_scenario;
    StudyRange m_range;
    bool m_isBell = false;
    ChoiceBox* m_parameters;
    QWidget* m_fields;  // another one for each parameter
    QuantityField* m_low = nullptr;
    QuantityField* m_high = nullptr;
    ChoiceBox* m_kind = nullptr;
    DensityMark* m_density = nullptr;
    QCheckBox* m_logarithmic = nullptr;
    QSpinBox* m_count = nullptr;
    QToolButton* m_remove;
};

/// Rows that can be added and removed. Once a parameter does not apply to the scenario any more, ranges are
/// proposed for all rows again.
class RangeRows : public QWidget {
    Q_OBJECT

  public:
    /// Holds at least and at most so many rows, below `words`.
    RangeRows(RangeUse use, const QString& words, std::size_t least, std::size_t most,
              const UnitChoice& units, QWidget* parent);

    /// Offers what applies to the scenario, and proposes ranges the first time.
    void present(const Scenario& scenario);
    /// Notes that the next scenario is another document, for which ranges are proposed again.
    void forget() { m_isProposed = false; }
    /// The texts of the rows, and those that no row can show.
    std::vector<std::string> texts() const;
    /// Shows these instead of the rows. Texts that no row can show stay as texts, with a button to remove
    /// each. Emits no changed().
    void setTexts(const std::vector<std::string>& texts);
    /// Removes the rows about one of these keys or its rivals, and proposes none of them, until other keys
    /// are excluded. Returns whether a row was removed; emits no changed().
    bool exclude(std::vector<std::string> keys);
    /// The first of those of the rows.
    QString problem() const;
    const std::vector<RangeRow*>& rows() const { return m_rows.rows(); }

  public slots:
    /// Adds a row with the parameter that is usually wanted next.
    void add();

  signals:
    /// texts() or problem() are other ones.
    void changed();

  private:
    RangeRow* append(const StudyRange& range);
    void appendText(const std::string& text);
    void clearTexts();
    bool isExcluded(std::string_view key) const;
    StudyRange proposal() const;
    void propose();

    RangeUse m_use;
    const UnitChoice& m_units;
    Scenario m_scenario;
    bool m_isProposed = false;
    QVBoxLayout* m_layout;
    QToolButton* m_add;
    RowList<RangeRow> m_rows;                               // in those
    std::vector<std::pair<std::string, QWidget*>> m_texts;  // that no row can show, with their lines
    std::vector<std::string> m_excluded;
};

}  // namespace drillwave
