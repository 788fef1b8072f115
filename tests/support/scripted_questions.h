// SPDX-License-Identifier: GPL-3.0-or-later
// Prepared answers to the window's questions, and a record of its messages, for tests.
#pragma once

#include <QPrinter>
#include <QStringList>

#include "ui/questions/questions.h"

namespace drillwave {

struct ScriptedAnswers {
    Questions::Unsaved unsaved = Questions::Unsaved::cancel;
    bool confirmClose = true;
    QString open;
    QString import;
    QStringList imports;  ///< answer to questions for several files
    QString save;
    QString exportTo;
    QString printTo;  ///< path of a PDF file to print to; empty cancels printing
    QString folder;
    std::optional<PictureChoice> picture;
    bool confirm = false;
    bool restart = false;
    QStringList restartAsked;
    Questions::Recovery recovery = Questions::Recovery::later;
    int unsavedAsked = 0;
    int importAsked = 0;
    QStringList confirmed;  ///< questions that had to be confirmed
    QStringList found;      ///< offers to recover unsaved changes
    QStringList told;
    QStringList unwritten;  ///< questions whether to close although something could not be written
};

class ScriptedQuestions : public Questions {
  public:
    explicit ScriptedQuestions(ScriptedAnswers& answers) : m_answers(answers) {}

    Unsaved unsavedChanges(QWidget* /*parent*/, const QString& /*name*/) override {
        ++m_answers.unsavedAsked;
        return m_answers.unsaved;
    }
    bool confirmClose(QWidget* /*parent*/, const QString& what, const QString& details) override {
        m_answers.unwritten.append(what + QLatin1Char('\n') + details);
        return m_answers.confirmClose;
    }
    QString fileToOpen(QWidget* /*parent*/, const QString& /*folder*/) override { return m_answers.open; }
    QString fileToImport(QWidget* /*parent*/, const QString& /*title*/, const QString& /*folder*/,
                         const QString& /*filter*/) override {
        ++m_answers.importAsked;
        return m_answers.import;
    }
    QStringList filesToImport(QWidget* /*parent*/, const QString& /*title*/, const QString& /*folder*/,
                              const QString& /*filter*/) override {
        ++m_answers.importAsked;
        return m_answers.import.isEmpty() ? m_answers.imports : QStringList{m_answers.import};
    }
    QString fileToSave(QWidget* /*parent*/, const QString& /*suggestion*/) override { return m_answers.save; }
    QString fileToExport(QWidget* /*parent*/, const QString& /*title*/, const QString& /*suggestion*/,
                         const QString& /*filter*/) override {
        return m_answers.exportTo;
    }
    std::unique_ptr<QPrinter> printer(QWidget* /*parent*/, const QString& title) override {
        if (m_answers.printTo.isEmpty()) return nullptr;
        auto printer = std::make_unique<QPrinter>(QPrinter::HighResolution);
        printer->setDocName(title);
        printer->setPageSize(QPageSize(QPageSize::A4));
        printer->setOutputFileName(m_answers.printTo);
        return printer;
    }
    QString folderToExport(QWidget* /*parent*/, const QString& /*suggestion*/) override {
        return m_answers.folder;
    }
    std::optional<PictureChoice> picture(QWidget* /*parent*/, const PictureChoice& /*before*/) override {
        return m_answers.picture;
    }
    bool confirm(QWidget* /*parent*/, const QString& question, const QString& details,
                 const QString& /*action*/) override {
        m_answers.confirmed.append(question + QLatin1Char('\n') + details);
        return m_answers.confirm;
    }
    Recovery recover(QWidget* /*parent*/, const QString& name, const QString& details) override {
        m_answers.found.append(name + QLatin1Char('\n') + details);
        return m_answers.recovery;
    }
    bool restartNow(QWidget* /*parent*/, const QString& question, const QString& details) override {
        m_answers.restartAsked.append(question + QLatin1Char('\n') + details);
        return m_answers.restart;
    }
    void tell(QWidget* /*parent*/, Tone /*tone*/, const QString& what, const QString& details) override {
        m_answers.told.append(what + QLatin1Char('\n') + details);
    }

  private:
    ScriptedAnswers& m_answers;
};

}  // namespace drillwave
