// SPDX-License-Identifier: GPL-3.0-or-later
// Dialog for importing a measured signal: the file, how to read it, and a preview of the result.
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

/// Dialog for importing a signal, which stays open beside the window. When it emits wanted(), its owner uses
/// the result and closes the dialog. The file is read in another thread.
class ImportDialog : public QDialog {
    Q_OBJECT

  public:
    /// Makes the dialog for a file. The document must outlive it.
    ImportDialog(const QString& path, ImportUse use, const Document& document, QWidget* parent);
    ~ImportDialog() override;

    QString path() const { return m_path; }
    ImportUse use() const;
    void setUse(ImportUse use);
    /// Returns the imported signal for the present choices; nullptr until it is computed, or if it cannot be
    /// used.
    const ShapedSignal* result() const;
    /// Returns the result as a measured signal with its name and position. Requires that result() is not
    /// nullptr.
    MeasuredSignal measured() const;
    /// Shows in the dialog the reason why its owner could not use the result.
    void refuse(const QString& reason);
    /// Returns true while the imported signal for the present choices is being computed.
    bool isBusy() const;
    /// Returns the present settings for reading files of this measuring instrument: columns, units, gauge and
    /// amplifier.
    SignalOptions settings() const;
    /// Returns the name under which the user wants to store the present settings for files of one recorder
    /// (measuring instrument).
    QString recorder() const;
    /// Offers the `recorders` by name: stored settings for the files of one measuring instrument each. Also
    /// offers the settings of the last import, `last`; they are empty if there was no import.
    void offer(std::vector<Recorder> recorders, Recorder last);

  signals:
    /// Emitted when the user asks to store the settings under the name recorder().
    void keepWanted();
    /// Emitted when the user accepts the result; result() is then not nullptr.
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

    /// Values that the dialog proposes next: the zero line as soon as the record is read, then sign and times
    /// of the signal, then nothing.
    enum class Proposal { zero, signAndTimes, none };

    QString m_path;
    QString m_unreadable;
    const Document& m_document;
    ChoiceBox* m_use = nullptr;
    QLineEdit* m_name;
    QComboBox* m_recorder = nullptr;
    QPushButton* m_keep = nullptr;
    std::vector<Recorder> m_recorders;  // recorders in the order of the box
    TableFields* m_table;
    SignalFields* m_signal;
    FileLines* m_lines;
    PlotWidget* m_plot;
    ImportPlot* m_drawing;
    QLabel* m_summary;
    QLabel* m_message;
    QPushButton* m_take = nullptr;
    QTimer m_ask;
    QString m_refusal;  // reason why the present result was refused
    Proposal m_proposal = Proposal::zero;
    StudyRunner<ImportQuestion, ImportPreview> m_study{ImportStudy()};
};

}  // namespace drillwave
