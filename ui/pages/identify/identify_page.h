// SPDX-License-Identifier: GPL-3.0-or-later
// The page Identify: which rock have records of strain gauges seen, and how sure is that?
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

/// A strip with the records, their gauges and what is known about them; below it the answer in a sentence,
/// the record with the model on it, what the model leaves over, and the rock; beside these the values with
/// their intervals. Several records have a list, of which one is on show. The line of the arrival can be
/// dragged: it moves the gauges along the rod.
class IdentifyPage : public StudyPage {
    Q_OBJECT

  public:
    /// The document must outlive it.
    explicit IdentifyPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("Identify"); }
    QList<PageExport> exports() const override;
    QString command() const override;

    /// Takes records from files, in their order along the hole, instead of those before. All tables are read
    /// with these settings.
    void openRecords(const QStringList& paths, const SignalOptions& settings = {});
    void openRecord(const QString& path, const SignalOptions& settings = {}) {
        openRecords({path}, settings);
    }
    /// Adds files to the list, whose tables are read like that of the first; those that are in it are read
    /// again. Requires that there is a record.
    void addRecords(const QStringList& paths);
    bool hasRecords() const { return !m_paths.isEmpty(); }
    /// How many identifications were started.
    int started() const { return m_asked.started(); }
    FigureFrame& figureFrame() const { return *m_frame; }
    GaugeFields& gaugeFields() const { return *m_gauges; }
    /// The answer that is shown; nullptr before the first, and where nothing is asked.
    IdentifiedRecordPtr answer() const { return m_shown; }

  signals:
    /// The user wants to choose records, or further ones.
    void recordWanted();
    void moreRecordsWanted();
    /// The user wants Design with this table of draws, whose rock is in the scenario now; `source` names the
    /// records.
    void drawsWanted(const QString& source, const QByteArray& table);

  protected:
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
    QString m_chosen;  // row of the list that the user has chosen, see rowName(); empty: that of the answer
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
        identifiedRecord};  // goes first: its thread works
};

}  // namespace drillwave
