// SPDX-License-Identifier: GPL-3.0-or-later
// Import of a measured signal: the file, how it is read, and what it gives, before anything is taken.
#pragma once

#include <QDialog>
#include <QTimer>

#include "core/signal/alignment.h"
#include "core/yaml/recorder_file.h"
#include "ui/document/document.h"
#include "ui/import/import_preview.h"
#include "ui/import/signal_fields.h"
#include "ui/job/study_job.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace drillwave {

class ChoiceBox;
class FileLines;
class ImportPlot;
class PlotWidget;
class TableFields;

/// Stays open beside the window until it is accepted by who made it, on wanted(), or closed. The file is read
/// away from the window's thread.
class ImportDialog : public QDialog {
    Q_OBJECT

  public:
    /// The document must outlive it.
    ImportDialog(const QString& path, ImportUse use, const Document& document, QWidget* parent);
    ~ImportDialog() override;

    QString path() const { return m_path; }
    ImportUse use() const;
    void setUse(ImportUse use);
    /// Returns the signal of the present choices; nullptr while it is not known or cannot be used.
    const ShapedSignal* result() const;
    /// The same as a measured signal.
    MeasuredSignal measured() const;
    /// Why it could not be taken, in place.
    void refuse(const QString& reason);
    /// Whether an answer is on its way.
    bool isBusy() const;
    /// The settings of the recorder as they now are: columns, units, gauge, amplifier.
    SignalOptions settings() const;
    /// The name under which the user wants them kept.
    QString recorder() const;
    /// Offers recorders by name, and the settings of the last import, empty where there was none.
    void offer(std::vector<Recorder> recorders, Recorder last);

  signals:
    /// The user wants the settings kept under recorder().
    void keepWanted();
    /// The user wants the result, which there is.
    void wanted();
    void helpRequested();

  private:
    QWidget* makeChoices();
    void addRecorders(QFormLayout& form);
    void useRecorder(const Recorder& recorder);
    QVBoxLayout* makePreview();
    QWidget* makeButtons();
    void readStart();
    void requestUpdate();
    void ask();
    void showAnswer();
    void proposeFrom(const ImportPreview& preview);
    void showState();
    QString obstacle() const;

    /// Proposals that wait until the record is read.
    enum class Proposal { zero, signAndTimes, none };

    QString m_path;
    QString m_unreadable;
    const Document& m_document;
    ChoiceBox* m_use = nullptr;
    QLineEdit* m_name;
    QComboBox* m_recorder = nullptr;
    QPushButton* m_keep = nullptr;
    std::vector<Recorder> m_recorders;  // in the order of the box
    TableFields* m_table;
    SignalFields* m_signal;
    FileLines* m_lines;
    PlotWidget* m_plot;
    ImportPlot* m_drawing;
    QLabel* m_summary;
    QLabel* m_message;
    QPushButton* m_take = nullptr;
    QTimer m_ask;
    QString m_refusal;  // of the present result
    Proposal m_proposal = Proposal::zero;
    StudyRunner<ImportQuestion, ImportPreview> m_study{ImportStudy()};
};

}  // namespace drillwave
