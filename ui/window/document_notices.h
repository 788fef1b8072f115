// SPDX-License-Identifier: GPL-3.0-or-later
// Notices about the document: its file, its form, its table and hints for an example.
#pragma once

#include <QAction>

#include "core/model/form_conversion.h"
#include "core/yaml/examples.h"
#include "ui/document/document.h"
#include "ui/document/file_watch.h"
#include "ui/questions/questions.h"
#include "ui/window/notice.h"

namespace drillwave {

// Reports that the file on disk differs from the scenario being edited, and offers remedies.

class FileNotice : public Notice {
    Q_OBJECT

  public:
    /// All three must outlive the notice.
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

// Reports that the file of a measured blow has changed on disk, and offers to read it again.

class TableNotice : public Notice {
    Q_OBJECT

  public:
    /// All three must outlive the notice.
    TableNotice(Document& document, TableWatch& watch, Questions& questions, QWidget* parent = nullptr);

  private:
    void tell(TableWatch::State state);
    void reload();

    Document& m_document;
    Questions& m_questions;
    QPushButton* m_reload;
};

// Converts a uniform rod to a drill string, or a string to a uniform rod, and reports what is lost.

class FormNotice : public Notice {
    Q_OBJECT

  public:
    /// The document must outlive it.
    explicit FormNotice(Document& document, QWidget* parent = nullptr);

    /// Actions of a menu; each is disabled if there is nothing to convert, with the reason as its tooltip.
    QAction* toString() const { return m_toString; }
    QAction* toUniformRod() const { return m_toUniformRod; }
    QAction* toRig() const { return m_toRig; }      ///< of dimensionless groups, by a RigDialog
    QAction* toForce() const { return m_toForce; }  ///< instead of the hammer of a string

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

// Hint for the example that is open.

class ExampleNote : public Notice {
    Q_OBJECT

  public:
    explicit ExampleNote(QWidget* parent = nullptr);

    /// Shows the explanation of an example.
    void explain(const Example& example);
    /// The example the program begins with: its explanation is not shown once the user has dismissed it.
    void explainFirst(const Example& example);
    /// The scenario is no longer that of the example, or is so again: the explanation may not fit its values.
    void setChanged(bool changed);
    /// Another scenario is open.
    void forget();
    /// Shows and hides the note; disabled where there is nothing to explain.
    QAction* action() const { return m_action; }

  private:
    void set(const Example& example);

    QAction* m_action;
    QString m_explanation;
    bool m_isFirst = false;
};

}  // namespace drillwave
