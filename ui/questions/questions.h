// SPDX-License-Identifier: GPL-3.0-or-later
// The questions that the window asks, apart from the window, so that tests and headless runs can answer them.
#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "ui/questions/picture_dialog.h"

class QPrinter;
class QWidget;

namespace drillwave {

class Questions {
  public:
    enum class Unsaved { save, discard, cancel };
    enum class Tone { information, failure };
    enum class Recovery { restore, discard, later };

    virtual ~Questions() = default;
    /// Asks whether to save or drop changes that would be lost.
    virtual Unsaved unsavedChanges(QWidget* parent, const QString& name) = 0;
    /// Whether to close the window although something has not been written: what, and why.
    virtual bool confirmClose(QWidget* parent, const QString& what, const QString& details) = 0;
    /// The file to open; empty when the user gave up.
    virtual QString fileToOpen(QWidget* parent, const QString& folder) = 0;
    /// A file to take something from, other than a scenario; empty when the user gave up.
    virtual QString fileToImport(QWidget* parent, const QString& title, const QString& folder,
                                 const QString& filter) = 0;
    /// The same for one file or several, in the order of their names as people count: 2 before 10.
    virtual QStringList filesToImport(QWidget* parent, const QString& title, const QString& folder,
                                      const QString& filter) = 0;
    /// Asks for a file to save to, overwriting confirmed; empty when the user gave up.
    virtual QString fileToSave(QWidget* parent, const QString& suggestion) = 0;
    /// Asks for a file to write something else than a scenario to, overwriting confirmed; empty when the user
    /// gave up. A name without an ending gets that of the filter.
    virtual QString fileToExport(QWidget* parent, const QString& title, const QString& suggestion,
                                 const QString& filter) = 0;
    /// A printer, set up by the user for a document of that name; nothing when the user gave up.
    virtual std::unique_ptr<QPrinter> printer(QWidget* parent, const QString& title) = 0;
    /// The folder to write several files into; empty when the user gave up.
    virtual QString folderToExport(QWidget* parent, const QString& suggestion) = 0;
    /// Format, size and resolution of a picture; nothing when the user gave up.
    virtual std::optional<PictureChoice> picture(QWidget* parent, const PictureChoice& before) = 0;
    /// Whether to do something that cannot be undone; `action` is the name of the button that does it.
    virtual bool confirm(QWidget* parent, const QString& question, const QString& details,
                         const QString& action) = 0;
    /// Asks whether to restore changes that were not saved when the program ended unexpectedly.
    virtual Recovery recover(QWidget* parent, const QString& name, const QString& details) = 0;
    /// Whether to open the window again now, with everything that is in it.
    virtual bool restartNow(QWidget* parent, const QString& question, const QString& details) = 0;
    /// Reports a failure, or gives information, without waiting for the user.
    virtual void tell(QWidget* parent, Tone tone, const QString& what, const QString& details) = 0;
};

/// Asks by dialogs. On a platform without a screen nobody could answer, so there every question is answered
/// by "cancel" or "later", but a window may always be closed: its unsaved changes are dropped. Messages are
/// printed to the error output.
class DialogQuestions : public Questions {
  public:
    Unsaved unsavedChanges(QWidget* parent, const QString& name) override;
    bool confirmClose(QWidget* parent, const QString& what, const QString& details) override;
    QString fileToOpen(QWidget* parent, const QString& folder) override;
    QString fileToImport(QWidget* parent, const QString& title, const QString& folder,
                         const QString& filter) override;
    QStringList filesToImport(QWidget* parent, const QString& title, const QString& folder,
                              const QString& filter) override;
    QString fileToSave(QWidget* parent, const QString& suggestion) override;
    QString fileToExport(QWidget* parent, const QString& title, const QString& suggestion,
                         const QString& filter) override;
    std::unique_ptr<QPrinter> printer(QWidget* parent, const QString& title) override;
    QString folderToExport(QWidget* parent, const QString& suggestion) override;
    std::optional<PictureChoice> picture(QWidget* parent, const PictureChoice& before) override;
    bool confirm(QWidget* parent, const QString& question, const QString& details,
                 const QString& action) override;
    Recovery recover(QWidget* parent, const QString& name, const QString& details) override;
    bool restartNow(QWidget* parent, const QString& question, const QString& details) override;
    void tell(QWidget* parent, Tone tone, const QString& what, const QString& details) override;
};

}  // namespace drillwave
