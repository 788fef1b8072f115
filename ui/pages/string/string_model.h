// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the sections: a row for each section as in the file, with editable numbers and the results of
// the blow.
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "ui/document/document.h"
#include "ui/pages/string/string_rows.h"

namespace drillwave {

/// Table model of the sections of the document's drill string. Every edit is one undo step; invalid values
/// are refused.
class StringModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column {
        repeat,
        sectionName,
        length,
        diameter,
        bore,
        loss,
        massAfter,
        attenuation,
        compression,
        tension,
        reflected,
        strengthShare,
        presetName,  // shown if a section is from a preset
        occasional,  // first of the numbers that few sections have
    };

    /// Returns the index of the column that shows a number of the sections, given by its key, such as "area".
    static int columnOf(std::string_view field);

    /// Returns a parameter for the table column with the key `field`, such as "bore". The unit chosen for
    /// this parameter is the unit of the column.
    static KeptParameter ofColumn(std::string_view field);

    /// Creates the model. The document must outlive it.
    explicit StringModel(Document& document, QObject* parent = nullptr);

    /// Returns whether a column is hidden while no section uses it, unless the user shows all columns. These
    /// are numbers that few sections have, presets, and reflections of joints.
    static bool isOccasional(int column) {
        return column >= presetName || column == massAfter || column == attenuation || column == reflected;
    }
    /// Returns whether any section has a value other than 0 in this column, so that the column is worth
    /// showing. False for strengths, which are shown only with all columns.
    bool isUsed(int column) const;

    /// Shows the results of a blow, such as its largest stresses, in the columns for results. `blow` must not
    /// be nullptr.
    void present(const SolvedBlowPtr& blow);

    const std::vector<StringRow>& rows() const { return m_rows; }
    const std::vector<ChainSection>& chain() const { return m_chain; }
    const std::optional<StringResults>& results() const { return m_results; }
    const SolvedBlowPtr& blow() const { return m_blow; }
    /// Returns the parameter that a cell shows; nullptr if the cell is a word, a result, or not applicable.
    KeptParameter parameterAt(const QModelIndex& index) const;
    /// Returns stress, place and time of a peak in the units shown: "362.2 MPa at 0.12 m from its rear end,
    /// 3.28 ms".
    QString peakText(const RowPeak& peak) const;
    /// Returns the header of a row: the number of its section in the string, such as "3", or in the hammer,
    /// such as "H1".
    QString placeText(int row) const;
    /// Returns the row of a section given by its position in the file; −1 if there is none.
    int rowOf(const SectionSpot& spot) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Sets the number (in SI) or the name in a cell. An invalid QVariant clears an optional number. Returns
    /// whether the value was accepted.
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

  signals:
    /// Reports why a cell refused its text; empty after a text was accepted.
    void refused(const QString& reason);

  private:
    void follow();
    QVariant shown(const QModelIndex& index) const;
    QString numberCell(const StringRow& row, const Parameter& parameter) const;
    QString repeatCell(const StringRow& row) const;
    QString resultCell(int row, int column) const;
    QString useText(const StringRow& row, const RowResult& result) const;
    QString toolTip(const QModelIndex& index) const;
    bool rename(const StringRow& row, const QString& name);
    bool setTimes(const StringRow& row, double times);
    bool report(const QString& problem);

    Document& m_document;
    SolvedBlowPtr m_blow;
    DrillString m_shown;  // drill string that the rows show
    std::vector<StringRow> m_rows;
    std::vector<ChainSection> m_chain;
    std::optional<StringResults> m_results;
};

}  // namespace drillwave
