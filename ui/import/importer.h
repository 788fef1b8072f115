// SPDX-License-Identifier: GPL-3.0-or-later
// Import of measured signals: asks for the file, opens the dialog and applies its result.
#pragma once

#include <QObject>
#include <QPointer>

#include "ui/document/document.h"
#include "ui/document/measured_list.h"
#include "ui/import/import_dialog.h"
#include "ui/questions/questions.h"

namespace drillwave {

/// Object that imports measured signals with one dialog at a time; it closes the dialog when deleted.
class Importer : public QObject {
    Q_OBJECT

  public:
    /// Makes an importer. All arguments must outlive it.
    Importer(Document& document, MeasuredList& measured, Questions& questions, QWidget* window);
    ~Importer() override;

    /// Asks for a file, or for several records of gauges, and opens the dialog; does nothing if the user
    /// cancels.
    void start(ImportUse use);
    /// Opens the import dialog for a file. The settings chosen there also apply to the files `further`, which
    /// are records of the same measurement.
    void open(const QString& path, ImportUse use, const QStringList& further = {});
    /// Asks for records of strain gauges, from which the rock's law is identified. Empty if the user cancels.
    QStringList chooseRecords();

  signals:
    /// Emitted after an import; `message` describes it in one line.
    void imported(const QString& message);
    /// Emitted when records for identifying the rock's law are chosen, with the settings for reading their
    /// tables.
    void recordsTaken(const QStringList& paths, const drillwave::SignalOptions& settings);

  private:
    QString folder() const;
    void take();
    QString takeBlow();
    QString takeMeasured();
    void offerRecorders();
    void keepRecorder();

    Document& m_document;
    MeasuredList& m_measured;
    Questions& m_questions;
    QWidget* m_window;
    QPointer<ImportDialog> m_dialog;
    QStringList m_further;
};

}  // namespace drillwave
