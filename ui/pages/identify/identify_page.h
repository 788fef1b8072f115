// SPDX-License-Identifier: GPL-3.0-or-later
// The page Identify: which rock has a record of strain gauges seen, and how sure is that?
#pragma once

#include "core/signal/signal_reading.h"
#include "ui/pages/identify/record_question.h"
#include "ui/pages/study/study_page.h"
#include "ui/text/shown_units.h"

class QLabel;

namespace drillwave {

class ChoiceBox;
class FigureFrame;
class GaugeFields;
class IdentifyPanel;
class KnownFields;
class SectionBox;

/// A strip with the record, its gauges and what is known about them; below it the answer in a sentence, the
/// record with the model on it, what the model leaves over, and the rock; beside these the values with their
/// intervals. The line of the arrival can be dragged: it moves the gauges along the rod.
class IdentifyPage : public StudyPage {
    Q_OBJECT

  public:
    /// The document must outlive it.
    explicit IdentifyPage(Document& document, QWidget* parent = nullptr);

    QString title() const override { return tr("Identify"); }
    QList<PageExport> exports() const override;
    QString command() const override;

    /// Takes a record from a file, whose table is read with these settings.
    void openRecord(const QString& path, const SignalOptions& settings = {});
    /// How many identifications were started.
    int started() const { return m_asked.started(); }
    FigureFrame& figureFrame() const { return *m_frame; }
    GaugeFields& gaugeFields() const { return *m_gauges; }
    /// The answer that is shown; nullptr before the first, and where nothing is asked.
    IdentifiedRecordPtr answer() const { return m_shown; }

  signals:
    /// The user wants to choose a record.
    void recordWanted();

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
    void draw();
    void moveArrival(double time);
    void useRock();
    void pinRock();
    void goToTolerance(const QString& key);

    QString m_path;
    SignalOptions m_settings;
    QLabel* m_name = nullptr;
    GaugeFields* m_gauges;
    ChoiceBox* m_law;
    ChoiceBox* m_backing = nullptr;
    ChoiceBox* m_dispersion = nullptr;
    SectionBox* m_knownBox = nullptr;
    KnownFields* m_known = nullptr;
    IdentifyPanel* m_panel;
    FigureFrame* m_frame;
    IdentifiedRecordPtr m_shown;
    ShownUnits m_shownUnits;
    AskedStudy<RecordQuestion, IdentifiedRecordPtr> m_asked{
        identifiedRecord};  // goes first: its thread works
};

}  // namespace drillwave
