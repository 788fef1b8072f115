// SPDX-License-Identifier: GPL-3.0-or-later
// The page Identify: properties of the rock from records of strain gauges, and their confidence intervals.
#pragma once

#include "core/signal/signal_reading.h"
#include "ui/pages/identify/record_question.h"
#include "ui/pages/study/study_page.h"
#include "ui/text/shown_units.h"

class QLabel;
class QPushButton;

namespace drillwave {

class ChoiceBox;
class FigureFrame;
class GaugeFields;
class IdentifyPanel;
class KnownFields;
class RecordList;
class SectionBox;

/// Page that identifies the rock from records of strain gauges. At the top are the records, their gauges and
/// the known tolerances. Below are the answer, the record with the model, their difference and the rock.
/// Beside them are the identified values with their intervals. If there are several records, they are listed
/// and one of them is shown. The user can drag the line at the arrival time of the reflected wave, which
/// changes the entered distance of the gauges from the bit.
class IdentifyPage : public StudyPage {
    Q_OBJECT

  public:
    /// Creates the page. The document must outlive it.
    explicit IdentifyPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("Identify"); }
    QList<PageExport> exports() const override;
    QString command() const override;

    /// Replaces the records of strain gauges by those in the files. The paths are in their order along the
    /// drilled hole. All files are read with the same settings.
    void openRecords(const QStringList& paths, const SignalOptions& settings = {});
    void openRecord(const QString& path, const SignalOptions& settings = {}) {
        openRecords({path}, settings);
    }
    /// Adds files to the list; their tables are read with the settings of the present records. Files that are
    /// already in the list are read again. Requires at least one record.
    void addRecords(const QStringList& paths);
    bool hasRecords() const { return !m_paths.isEmpty(); }
    /// Returns how many identifications the page has started, for tests.
    int started() const { return m_asked.started(); }
    FigureFrame& figureFrame() const { return *m_frame; }
    GaugeFields& gaugeFields() const { return *m_gauges; }
    /// Returns the answer that is shown; nullptr before the first one and if no question is asked.
    IdentifiedRecordPtr answer() const { return m_shown; }

  signals:
    /// Reports that the user wants to choose files with records of strain gauges.
    void recordWanted();
    /// Reports that the user wants to add further records.
    void moreRecordsWanted();
    /// Reports that the user wants to use the identified rock as uncertain input of the page Design. `table`
    /// is CSV; each row has one possible set of rock values. `source` names the records. The scenario already
    /// has the rock of the best fit.
    void drawsWanted(const QString& source, const QByteArray& table);

  protected:
    bool canFoldSettings() const override { return hasRecords(); }  // they have the button that opens records
    void ask() override;
    void present() override;
    QByteArray csv() const override;
    QStringList commandWords() const override;
    QString answerText() const override;

  private:
    QWidget* makeRecordBox();
    QWidget* makeKnownBox();
    ChoiceBox* makeChoice(const char* name, const QString& title, const QString& tip,
                          const QStringList& entries);
    RecordQuestion question() const;
    void showKnown(const RecordQuestion& question);
    const RecordAnswer& shownRecord() const;
    QString nameOf(const RecordAnswer& record) const;
    void removeRecord(const QString& path);
    void takeFiles(const QStringList& paths);
    void showRecords();
    void showNames();
    void showSide(bool hasAnswer);
    QString sourceWords() const;
    void draw();
    void moveArrival(double time);
    void useRock();
    void pinRock();
    void designDraws();
    void goToTolerance(const QString& key);

    QStringList m_paths;
    int m_opened = 0;
    SignalOptions m_settings;
    // Row of the list that the user has chosen, see rowName(). If empty, the row of the answer is shown.
    QString m_chosen;
    QLabel* m_name = nullptr;
    QPushButton* m_more = nullptr;
    GaugeFields* m_gauges;
    ChoiceBox* m_law;
    ChoiceBox* m_backing = nullptr;
    ChoiceBox* m_dispersion = nullptr;
    SectionBox* m_knownBox = nullptr;
    KnownFields* m_known = nullptr;
    ChoiceBox* m_blows = nullptr;
    QWidget* m_side;
    RecordList* m_records;
    IdentifyPanel* m_panel;
    FigureFrame* m_frame;
    IdentifiedRecordPtr m_shown;
    ShownUnits m_shownUnits;
    StudyRunner<RecordQuestion, IdentifiedRecordPtr> m_asked{
        identifiedRecord};  // destroyed first, because its thread uses other members
};

}  // namespace drillwave
