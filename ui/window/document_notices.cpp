// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/document_notices.h"

#include <QFileInfo>
#include <QPushButton>

#include "ui/form/rig_dialog.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

const QString firstDismissedKey = QStringLiteral("window/firstNoteDismissed");

}  // namespace

FileNotice::FileNotice(Document& document, FileWatch& watch, Questions& questions, QWidget* parent)
    : Notice(Tone::warning, parent),
      m_document(document),
      m_watch(watch),
      m_questions(questions),
      m_reload(
          addButton(tr("&Reload"), tr("Load the scenario from the file; Undo brings the present one back"))) {
    setObjectName(QStringLiteral("fileNotice"));
    m_reload->setObjectName(QStringLiteral("reload"));
    QPushButton* keep =
        addButton(tr("&Keep mine"), tr("Continue with the present scenario; saving overwrites the file"));
    keep->setObjectName(QStringLiteral("keep"));
    connect(m_reload, &QPushButton::clicked, this, &FileNotice::reload);
    connect(keep, &QPushButton::clicked, this, &FileNotice::keep);
    connect(this, &Notice::dismissed, &m_document, &Document::markUnsaved);
    connect(&m_watch, &FileWatch::differs, this, &FileNotice::tell);
    connect(&m_watch, &FileWatch::agrees, this, &QWidget::hide);
}

void FileNotice::tell(FileWatch::State state) {
    const QString name = QFileInfo(m_document.path()).fileName();
    m_reload->setVisible(state == FileWatch::State::changed);
    if (state == FileWatch::State::missing)
        say(tr("%1 has been deleted or moved. Saving writes it again.").arg(name));
    else if (m_document.isModified())
        say(tr("%1 has been changed by another program, and here as well.").arg(name));
    else
        say(tr("%1 has been changed by another program.").arg(name));
    // The scenario on show is in no file any more: closing must not drop it unasked.
    if (state == FileWatch::State::missing) m_document.markUnsaved();
}

void FileNotice::reload() {
    const QString problem = m_document.reload();
    if (problem.isEmpty())
        m_watch.check();
    else
        m_questions.tell(window(), Questions::Tone::failure, tr("The file cannot be reloaded."), problem);
}

void FileNotice::keep() {
    m_watch.accept();
    m_document.markUnsaved();
    hide();
}

TableNotice::TableNotice(Document& document, TableWatch& watch, Questions& questions, QWidget* parent)
    : Notice(Tone::warning, parent),
      m_document(document),
      m_questions(questions),
      m_reload(
          addButton(tr("&Reload"), tr("Read the hammer blow from the file again; Undo brings the present one "
                                      "back"))) {
    setObjectName(QStringLiteral("tableNotice"));
    m_reload->setObjectName(QStringLiteral("reloadBlow"));
    QPushButton* keep = addButton(tr("&Keep mine"), tr("Continue with the points read before"));
    keep->setObjectName(QStringLiteral("keepBlow"));
    connect(m_reload, &QPushButton::clicked, this, &TableNotice::reload);
    connect(keep, &QPushButton::clicked, this, &QWidget::hide);
    connect(&watch, &TableWatch::differs, this, &TableNotice::tell);
    connect(&watch, &TableWatch::agrees, this, &QWidget::hide);
}

void TableNotice::tell(TableWatch::State state) {
    const QString name = QFileInfo(m_document.tablePath()).fileName();
    m_reload->setVisible(state == TableWatch::State::changed);
    if (state == TableWatch::State::changed)
        say(tr("%1, the hammer blow of this scenario, has been changed by another program.").arg(name));
    else
        say(tr("%1, the hammer blow of this scenario, has been deleted or moved. Its points are still here, "
               "but the "
               "scenario cannot be opened without the file.")
                .arg(name));
}

void TableNotice::reload() {
    const QString problem = m_document.reloadTable();
    if (problem.isEmpty())
        hide();  // also where the numbers are the same, written otherwise
    else
        m_questions.tell(window(), Questions::Tone::failure, tr("The hammer blow cannot be read again."),
                         problem);
}

FormNotice::FormNotice(Document& document, QWidget* parent)
    : Notice(Tone::information, parent),
      m_document(document),
      m_toString(new QAction(tr("&Make a drill string of this"), this)),
      m_toUniformRod(new QAction(tr("&Simplify to a uniform rod"), this)),
      m_toForce(new QAction(tr("Use a &force instead of the hammer"), this)),
      m_toRig(new QAction(tr("Make a &rig of these groups…"), this)) {
    m_toRig->setObjectName(QStringLiteral("toRig"));
    m_toForce->setObjectName(QStringLiteral("toForce"));
    setObjectName(QStringLiteral("formNotice"));
    QPushButton* undo = addButton(tr("Undo"), tr("Undo the conversion"));
    connect(undo, &QPushButton::clicked, &document.undoStack(), &QUndoStack::undo);
    connect(m_toString, &QAction::triggered, this, [this] {
        convert(
            stringOf(m_document.scenario()), tr("make a drill string"),
            tr("This is a drill string now: a hammer and one rod, to which couplings, an adapter and a bit "
               "can be added on the page String."));
    });
    connect(m_toUniformRod, &QAction::triggered, this, [this] {
        convert(uniformRodOf(m_document.scenario()), tr("simplify to a uniform rod"),
                tr("This is a uniform rod now, with the same travel time of waves as the string."));
    });
    connect(m_toForce, &QAction::triggered, this, [this] {
        convert(forcedStringOf(m_document.scenario()), tr("use a force instead of the hammer"),
                tr("A force drives the string now: any shape, or a measured blow by File ▸ Import."));
    });
    connect(m_toRig, &QAction::triggered, this, [this] { (new RigDialog(m_document, window()))->open(); });
    // Any later change, for example an undo, makes another scenario.
    connect(&document, &Document::scenarioChanged, this, [this] {
        if (!m_isConverting) hide();
        offer();
    });
    offer();
}

void FormNotice::convert(const Conversion& conversion, const QString& step, const QString& done) {
    m_isConverting = true;
    const QString problem = m_document.useScenario(conversion.scenario, step);
    m_isConverting = false;
    if (!problem.isEmpty()) return say(tr("Nothing was converted: %1").arg(problem));
    QString text = done;
    if (!conversion.lost.empty()) text += QLatin1Char('\n') + tr("Lost or changed:");
    for (const Message& sentence : conversion.lost) text += QStringLiteral("\n• ") + translated(sentence);
    say(text);
}

void FormNotice::offer() {
    const Scenario& scenario = m_document.scenario();
    const QString reason = translated(whyNoString(scenario));
    m_toString->setEnabled(reason.isEmpty());
    m_toString->setToolTip(reason.isEmpty() ? tr("Makes a hammer and a rod with the same blow, to which "
                                                 "couplings, an adapter and a bit can be added")
                                            : tr("Not of this scenario: %1").arg(reason));
    m_toRig->setEnabled(!hasUnits(scenario));
    m_toRig->setToolTip(hasUnits(scenario)
                            ? tr("This scenario has physical units already")
                            : tr("Rod, force and duration of a physical scenario with the same groups"));
    const Section* kept = ruleSection(scenario.drillString);
    m_toUniformRod->setEnabled(kept);
    m_toUniformRod->setToolTip(
        kept ? tr("Only the rod, as long for the waves as the string, struck by a uniform piston")
             : tr("This scenario is a uniform rod"));
    m_toForce->setEnabled(!isForced(scenario));
    m_toForce->setToolTip(isForced(scenario)
                              ? tr("A force drives this scenario already")
                              : tr("A force that reflected waves do not change, as a measured blow is"));
}

ExampleNote::ExampleNote(QWidget* parent) : Notice(Tone::information, parent), m_action(new QAction(this)) {
    setObjectName(QStringLiteral("exampleNote"));
    m_action->setText(tr("&About this example"));
    m_action->setToolTip(tr("Things to look at in the open example"));
    m_action->setCheckable(true);
    m_action->setEnabled(false);
    connect(m_action, &QAction::toggled, this, &QWidget::setVisible);
    connect(this, &Notice::dismissed, this, [this] {
        m_action->setChecked(false);
        if (m_isFirst) Settings().setValue(firstDismissedKey, true);
    });
}

void ExampleNote::set(const Example& example) {
    m_explanation = coreText(example.explanation);
    say(m_explanation);
    m_action->setEnabled(true);
    m_action->setChecked(true);
}

void ExampleNote::explain(const Example& example) {
    m_isFirst = false;
    set(example);
}

void ExampleNote::explainFirst(const Example& example) {
    set(example);
    m_isFirst = true;
    if (Settings().value(firstDismissedKey).toBool()) m_action->setChecked(false);
}

void ExampleNote::setChanged(bool changed) {
    if (m_explanation.isEmpty()) return;
    setText(changed ? tr("You have changed this example: its description may no longer be right. Undo brings "
                         "the values back.")
                    : m_explanation);
}

void ExampleNote::forget() {
    m_explanation.clear();
    m_isFirst = false;
    m_action->setChecked(false);
    m_action->setEnabled(false);
}

}  // namespace drillwave
