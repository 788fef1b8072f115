// The questions that the window asks, apart from the window, so that tests and headless runs can answer them.
#pragma once

#include <QString>

class QWidget;

namespace drillwave {

class Questions {
  public:
    enum class Unsaved { save, discard, cancel };
    enum class Tone { information, failure };

    virtual ~Questions() = default;
    /// What to do with changes that would be lost.
    virtual Unsaved unsavedChanges(QWidget* parent, const QString& name) = 0;
    /// The file to open; empty when the user gave up.
    virtual QString fileToOpen(QWidget* parent, const QString& folder) = 0;
    /// Where to save, overwriting confirmed; empty when the user gave up.
    virtual QString fileToSave(QWidget* parent, const QString& suggestion) = 0;
    /// Tells of a failure, or gives information, without waiting for the user.
    virtual void tell(QWidget* parent, Tone tone, const QString& what, const QString& details) = 0;
};

/// Asks by dialogs. On a platform without a screen nobody could answer, so there every question is answered
/// by "cancel" and the unsaved changes of a closing window are dropped; what is told goes to the error
/// output.
class DialogQuestions : public Questions {
  public:
    Unsaved unsavedChanges(QWidget* parent, const QString& name) override;
    QString fileToOpen(QWidget* parent, const QString& folder) override;
    QString fileToSave(QWidget* parent, const QString& suggestion) override;
    void tell(QWidget* parent, Tone tone, const QString& what, const QString& details) override;
};

}  // namespace drillwave
