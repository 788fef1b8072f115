// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the sections: a row for each as in a file, with numbers to be edited and the results of the
// blow.
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "ui/document/document.h"
#include "ui/pages/string/string_rows.h"

namespace drillwave {

/// Shows the document's string. Every edit is one step of its history; invalid values stay out of it.
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
        presetName,  // shown where a section is from a preset
        occasional,  // from here on the other numbers of a section, which few have
    };

    /// The column of that number of a section, "area".
    static int columnOf(std::string_view field);

    /// Returns the parameter whose units show numbers of that key, "bore", for any section.
    static KeptParameter ofColumn(std::string_view field);

    /// The document must outlive the model.
    explicit StringModel(Document& document, QObject* parent = nullptr);

    /// Whether it is a column of numbers that few sections have, and whether one of these has it.
    static bool isOccasional(int column) { return column >= presetName; }
    bool isUsed(int column) const;

    /// The blow whose results the last columns show; nullptr before the first.
    void present(const SolvedBlowPtr& blow);

    const std::vector<StringRow>& rows() const { return m_rows; }
    const std::vector<ChainSection>& chain() const { return m_chain; }
    const std::optional<StringResults>& results() const { return m_results; }
    const SolvedBlowPtr& blow() const { return m_blow; }
    /// The number that a cell is; nullptr where it is a word, a result, or nothing of that section.
    KeptParameter parameterAt(const QModelIndex& index) const;
    /// Stress, place and time of a peak as the results are shown: "362.2 MPa at 0.12 m, 3.28 ms".
    QString peakText(const RowPeak& peak) const;
    /// The place of a row in keys: "3", "H1" in the hammer.
    QString placeText(int row) const;
    /// Returns the row of a spot; −1 if there is none.
    int rowOf(const SectionSpot& spot) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Takes a number in SI, or a name; nothing takes a number away that may be missing.
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

  signals:
    /// Why a cell did not take its text; empty when one has.
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
    DrillString m_shown;  // what the rows are of
    std::vector<StringRow> m_rows;
    std::vector<ChainSection> m_chain;
    std::optional<StringResults> m_results;
};

}  // namespace drillwave
