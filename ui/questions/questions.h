// SPDX-License-Identifier: GPL-3.0-or-later
// Questions that the window asks, separated from the window so that tests can answer them.
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
    /// Asks whether to save or discard changes that would be lost; `name` is the scenario's name.
    virtual Unsaved unsavedChanges(QWidget* parent, const QString& name) = 0;
    /// Asks whether to close the window although something could not be written; `what` and `details` say
    /// what, and why. Returns true to close.
    virtual bool confirmClose(QWidget* parent, const QString& what, const QString& details) = 0;
    /// Asks for a scenario file and returns its path; empty if the user cancels.
    virtual QString fileToOpen(QWidget* parent, const QString& folder) = 0;
    /// Asks for a file of another kind than a scenario and returns its path; empty if the user cancels.
    virtual QString fileToImport(QWidget* parent, const QString& title, const QString& folder,
                                 const QString& filter) = 0;
    /// Asks for one or several files and returns their paths; empty if the user cancels. They are sorted by
    /// name with numbers in numerical order (2 before 10).
    virtual QStringList filesToImport(QWidget* parent, const QString& title, const QString& folder,
                                      const QString& filter) = 0;
    /// Asks for a path to save a scenario to, confirms overwriting, and returns the path; empty if the user
    /// cancels.
    virtual QString fileToSave(QWidget* parent, const QString& suggestion) = 0;
    /// Asks for a path to write another file than a scenario, confirms overwriting, and returns the path;
    /// empty if the user cancels. A name without an ending gets that of the filter.
    virtual QString fileToExport(QWidget* parent, const QString& title, const QString& suggestion,
                                 const QString& filter) = 0;
    /// Asks for a printer and its settings, and returns it; nullptr if the user cancels. `title` is the
    /// document's name.
    virtual std::unique_ptr<QPrinter> printer(QWidget* parent, const QString& title) = 0;
    /// Asks for a folder into which several files will be written, and returns its path; empty if the user
    /// cancels.
    virtual QString folderToExport(QWidget* parent, const QString& suggestion) = 0;
    /// Asks for format, size and resolution of a picture; nothing if the user cancels. `before` is the
    /// initial choice.
    virtual std::optional<PictureChoice> picture(QWidget* parent, const PictureChoice& before) = 0;
    /// Asks whether to do something that cannot be undone, and returns true if so; `action` is the text of
    /// the button that confirms.
    virtual bool confirm(QWidget* parent, const QString& question, const QString& details,
                         const QString& action) = 0;
    /// Asks whether to restore changes that were not saved when the program ended unexpectedly.
    virtual Recovery recover(QWidget* parent, const QString& name, const QString& details) = 0;
    /// Asks whether to close the window and open it again now with all its contents, and returns true if so.
    virtual bool restartNow(QWidget* parent, const QString& question, const QString& details) = 0;
    /// Shows a message (information or failure) without waiting for the user.
    virtual void tell(QWidget* parent, Tone tone, const QString& what, const QString& details) = 0;
};

/// Questions asked by dialogs. On a platform without a screen nothing is asked. Then unsaved changes are
/// discarded, closing is confirmed, and every other question is answered by "cancel" or "later". Messages are
/// printed to stderr.
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
