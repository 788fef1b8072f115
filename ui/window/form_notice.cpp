// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/form_notice.h"

#include <QPushButton>

#include "core/model/blow_traits.h"
#include "ui/form/rig_dialog.h"
#include "ui/text/shown_text.h"

namespace drillwave {

FormNotice::FormNotice(Document& document, QWidget* parent)
    : Notice(Tone::information, parent),
      m_document(document),
      m_toString(new QAction(tr("&Make a drill string of this"), this)),
      m_toUniformRod(new QAction(tr("&Simplify to a uniform rod"), this)),
      m_toForce(new QAction(tr("Put a &force in place of the hammer"), this)),
      m_toRig(new QAction(tr("Make a &rig of these groups…"), this)) {
    m_toRig->setObjectName(QStringLiteral("toRig"));
    m_toForce->setObjectName(QStringLiteral("toForce"));
    setObjectName(QStringLiteral("formNotice"));
    QPushButton* undo = addButton(tr("Undo"), tr("Take the conversion back"));
    connect(undo, &QPushButton::clicked, &document.undoStack(), &QUndoStack::undo);
    connect(m_toString, &QAction::triggered, this, [this] {
        convert(
            stringOf(m_document.scenario()), tr("make a drill string"),
            tr("This is a drill string now: a hammer and one rod, to which couplings, an adapter and a bit "
               "can be added on the page String."));
    });
    connect(m_toUniformRod, &QAction::triggered, this, [this] {
        convert(uniformRodOf(m_document.scenario()), tr("simplify to a uniform rod"),
                tr("This is a uniform rod now, through which waves travel as long as through the string."));
    });
    connect(m_toForce, &QAction::triggered, this, [this] {
        convert(forcedStringOf(m_document.scenario()), tr("put a force in place of the hammer"),
                tr("A force drives the string now: any shape, or a measured blow by File ▸ Import."));
    });
    connect(m_toRig, &QAction::triggered, this, [this] { (new RigDialog(m_document, window()))->open(); });
    // Whatever comes after it, an undo for one, is another scenario.
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
    m_toString->setToolTip(
        reason.isEmpty()
            ? tr("A hammer and a rod of the same blow, to add couplings, an adapter and a bit to")
            : tr("Not of this scenario: %1").arg(reason));
    m_toRig->setEnabled(!hasUnits(scenario));
    m_toRig->setToolTip(hasUnits(scenario)
                            ? tr("This scenario has physical units already")
                            : tr("Rod, force and duration of a physical scenario with the same groups"));
    m_toUniformRod->setEnabled(hasSections(scenario));
    m_toUniformRod->setToolTip(
        hasSections(scenario)
            ? tr("The rod alone, as long for the waves as the string, struck by a uniform piston")
            : tr("This scenario is a uniform rod"));
    m_toForce->setEnabled(!isForced(scenario));
    m_toForce->setToolTip(isForced(scenario)
                              ? tr("A force drives this scenario already")
                              : tr("A force that does not feel what comes back, as a measured blow is"));
}

}  // namespace drillwave
