// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of parameter ranges: for uncertain inputs, or for design variables.
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

/// Use of parameter ranges: for uncertain inputs, or for design variables (`chosen`), for which the study
/// seeks the best values.
enum class RangeUse { uncertain, chosen };

/// Row for the range of one parameter, with its distribution or with the number of values to try. Invalid
/// text stays in its field, is marked, and changes nothing.
class RangeRow : public QWidget {
    Q_OBJECT

  public:
    /// Creates a row. The units must outlive it.
    RangeRow(RangeUse use, const UnitChoice& units, QWidget* parent);

    /// Lists the parameters that apply to the scenario. A newly chosen parameter gets the range from 0.5 to
    /// 1.5 times its present value, or another range if the value is 0.
    void present(const Scenario& scenario);
    const StudyRange& range() const { return m_range; }
    void setRange(const StudyRange& range);
    /// Returns the range as an argument of the command line: "bit_rock.gamma=0.05:0.3:normal",
    /// "pulse.duration=100 us:400 us:11".
    std::string text() const;
    /// Shows the range given as an argument of the command line. Returns false and changes nothing if the
    /// controls cannot show it.
    bool setText(const std::string& text);
    /// Returns why the text of a field is invalid, with the name of the field; empty if all fields are valid.
    QString problem() const;
    void setRemovable(bool removable);

  signals:
    /// Reports that text() or problem() has changed.
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
    QWidget* m_fields;  // fields of the ends; replaced for each parameter
    QuantityField* m_low = nullptr;
    QuantityField* m_high = nullptr;
    ChoiceBox* m_kind = nullptr;
    DensityMark* m_density = nullptr;
    QCheckBox* m_logarithmic = nullptr;
    QSpinBox* m_count = nullptr;
    QToolButton* m_remove;
};

/// List of parameter ranges that the user can add and remove. If a parameter no longer applies to the
/// scenario, all rows are replaced by proposed ranges.
class RangeRows : public QWidget {
    Q_OBJECT

  public:
    /// Creates a list of `least` to `most` rows below the heading `words`. The units must outlive it.
    RangeRows(RangeUse use, const QString& words, std::size_t least, std::size_t most,
              const UnitChoice& units, QWidget* parent);

    /// Lists the parameters of the scenario, for the user to choose from. The first call replaces the rows by
    /// rows with proposed ranges.
    void present(const Scenario& scenario);
    /// Notes that the next scenario belongs to another document: present() then proposes ranges again.
    void forget() { m_isProposed = false; }
    /// Returns the ranges as arguments of the command line, including those that no row can show.
    std::vector<std::string> texts() const;
    /// Replaces the rows by ranges given as arguments of the command line. An argument that no row can show
    /// is listed as text with a button to remove it. Emits no changed().
    void setTexts(const std::vector<std::string>& texts);
    /// Removes the rows of these parameters, and of parameters that set the same value by another key. They
    /// are no longer proposed, until the next call. Returns whether a row was removed; emits no changed().
    bool exclude(std::vector<std::string> keys);
    /// Returns the first error message of the rows; empty if all rows are valid.
    QString problem() const;
    const std::vector<RangeRow*>& rows() const { return m_rows.rows(); }

  public slots:
    /// Adds a row for the next proposed parameter that has no row yet.
    void add();

  signals:
    /// Reports that texts() or problem() has changed.
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
    RowList<RangeRow> m_rows;  // rows in m_layout
    // Arguments that no row can show, with their widgets.
    std::vector<std::pair<std::string, QWidget*>> m_texts;
    std::vector<std::string> m_excluded;
};

}  // namespace drillwave
