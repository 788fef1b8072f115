// SPDX-License-Identifier: GPL-3.0-or-later
// Imports measured signals: asks for the file, opens the dialog, and puts where it belongs what it gives.
#pragma once

#include <QObject>
#include <QPointer>

#include "ui/document/document.h"
#include "ui/document/measured_list.h"
#include "ui/import/import_dialog.h"
#include "ui/questions/questions.h"

namespace drillwave {

/// One dialog at a time; it goes with this.
class Importer : public QObject {
    Q_OBJECT

  public:
    /// All of them, `window` too, must outlive it.
    Importer(Document& document, MeasuredList& measured, Questions& questions, QWidget* window);
    ~Importer() override;

    /// Asks for a file, unless the user gives up, and opens the dialog for it.
    void start(ImportUse use);
    /// Opens the dialog for a file; the settings are those of `further` records, too.
    void open(const QString& path, ImportUse use, const QStringList& further = {});
    /// Asks for records to read the rock from; empty when the user gave up.
    QStringList chooseRecords();

  signals:
    /// One line about the import that was done.
    void imported(const QString& message);
    /// Records to read the rock from have been chosen, with the settings by which their tables are read.
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
