// Answers to the window's questions that a test has prepared, and a record of what it was told.
#pragma once

#include <QStringList>

#include "ui/questions.h"

namespace drillwave {

struct ScriptedAnswers {
    Questions::Unsaved unsaved = Questions::Unsaved::cancel;
    QString open;
    QString save;
    int unsavedAsked = 0;
    QStringList told;
};

class ScriptedQuestions : public Questions {
  public:
    explicit ScriptedQuestions(ScriptedAnswers& answers) : m_answers(answers) {}

    Unsaved unsavedChanges(QWidget* /*parent*/, const QString& /*name*/) override {
        ++m_answers.unsavedAsked;
        return m_answers.unsaved;
    }
    QString fileToOpen(QWidget* /*parent*/, const QString& /*folder*/) override { return m_answers.open; }
    QString fileToSave(QWidget* /*parent*/, const QString& /*suggestion*/) override { return m_answers.save; }
    void tell(QWidget* /*parent*/, Tone /*tone*/, const QString& what, const QString& details) override {
        m_answers.told.append(what + QLatin1Char('\n') + details);
    }

  private:
    ScriptedAnswers& m_answers;
};

}  // namespace drillwave
