// SPDX-License-Identifier: GPL-3.0-or-later
// Notices about the document: its file, its conversion, its table, and hints for an example.
#pragma once

#include <QAction>

#include "core/model/form_conversion.h"
#include "core/yaml/examples.h"
#include "ui/document/document.h"
#include "ui/document/file_watch.h"
#include "ui/questions/questions.h"
#include "ui/window/notice.h"

namespace drillwave {

// Notice that the file on disk differs from the scenario being edited, with buttons to reload it or keep the
// scenario.

class FileNotice : public Notice {
    Q_OBJECT

  public:
    /// Creates the notice. `document`, `watch` (of its file) and `questions`, which shows dialogs, must
    /// outlive it.
    FileNotice(Document& document, FileWatch& watch, Questions& questions, QWidget* parent = nullptr);

  private:
    void tell(FileWatch::State state);
    void reload();
    void keep();

    Document& m_document;
    FileWatch& m_watch;
    Questions& m_questions;
    QPushButton* m_reload;
};

// Notice that the file of a measured hammer force has changed on disk, with a button to read it again.

class TableNotice : public Notice {
    Q_OBJECT

  public:
    /// Creates the notice. `document`, `watch` (of its CSV file) and `questions`, which shows dialogs, must
    /// outlive it.
    TableNotice(Document& document, TableWatch& watch, Questions& questions, QWidget* parent = nullptr);

  private:
    void tell(TableWatch::State state);
    void reload();

    Document& m_document;
    Questions& m_questions;
    QPushButton* m_reload;
};

// Conversion between uniform rod and drill string, with a notice of what is lost.

class FormNotice : public Notice {
    Q_OBJECT

  public:
    /// Creates the menu actions that convert the scenario, for example from a uniform rod to a drill string.
    /// The document must outlive this object.
    explicit FormNotice(Document& document, QWidget* parent = nullptr);

    /// Returns the menu action that converts a uniform rod to a drill string. Like all actions of this class,
    /// it is disabled if there is nothing to convert, with the reason as its tooltip.
    QAction* toString() const { return m_toString; }
    /// Returns the action that simplifies a drill string to a uniform rod.
    QAction* toUniformRod() const { return m_toUniformRod; }
    /// Returns the action that gives a dimensionless scenario physical units. It opens a dialog (RigDialog)
    /// that asks for rod, mean force and duration.
    QAction* toRig() const { return m_toRig; }
    /// Returns the action that replaces the hammer of a drill string by a prescribed force on the string.
    QAction* toForce() const { return m_toForce; }

  private:
    void convert(const Conversion& conversion, const QString& step, const QString& done);
    void offer();

    Document& m_document;
    QAction* m_toString;
    QAction* m_toUniformRod;
    QAction* m_toForce;
    QAction* m_toRig;
    bool m_isConverting = false;
};

// Notice with hints for the built-in example that is open.

class ExampleNote : public Notice {
    Q_OBJECT

  public:
    explicit ExampleNote(QWidget* parent = nullptr);

    /// Shows the explanatory text of an example scenario that was opened.
    void explain(const Example& example);
    /// Shows the explanation of the example with which the program starts, unless the user has closed it in
    /// this or an earlier session.
    void explainFirst(const Example& example);
    /// Shows a hint that the explanation may no longer be right if the example has been changed (true).
    /// Otherwise shows the explanation again.
    void setChanged(bool changed);
    /// Removes the explanation of the example and hides the notice. Must be called when another scenario is
    /// opened.
    void forget();
    /// Returns the action that shows and hides the explanation of the example; disabled if there is no
    /// explanation.
    QAction* action() const { return m_action; }

  private:
    void set(const Example& example);

    QAction* m_action;
    QString m_explanation;
    bool m_isFirst = false;
};

}  // namespace drillwave
