// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/example_note.h"

#include "ui/text/settings.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

const QString firstDismissedKey = QStringLiteral("window/firstNoteDismissed");

}  // namespace

ExampleNote::ExampleNote(QWidget* parent) : Notice(Tone::information, parent), m_action(new QAction(this)) {
    setObjectName(QStringLiteral("exampleNote"));
    m_action->setText(tr("&About this example"));
    m_action->setToolTip(tr("What to look at in the example that is open"));
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
    setText(
        changed
            ? tr("You have changed this example: what is said of its values may no longer hold. Undo brings "
                 "them back.")
            : m_explanation);
}

void ExampleNote::forget() {
    m_explanation.clear();
    m_isFirst = false;
    m_action->setChecked(false);
    m_action->setEnabled(false);
}

}  // namespace drillwave
