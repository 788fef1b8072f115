// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/indexing_box.h"

#include <QLabel>
#include <QSignalBlocker>

#include "ui/form/choice_box.h"
#include "ui/form/parameter_row.h"

namespace drillwave {

IndexingBox::IndexingBox(Document& document, QGridLayout* grid, QWidget* parent)
    : QObject(parent), m_document(document), m_box(new ChoiceBox(parent)) {
    auto* label = new QLabel(tr("rock"), parent);
    label->setBuddy(m_box);
    m_box->setObjectName(QStringLiteral("drill.indexing"));
    m_box->setAccessibleName(tr("Machine: rock"));
    m_box->setToolTip(
        tr("Whether the bit is turned onto new rock for every blow, or strikes the same crater again"));
    for (const QString& words : {tr("new for every blow"), tr("the same crater")}) m_box->addItem(words);
    const int row = grid->rowCount();
    grid->addWidget(label, row, 0);
    grid->addWidget(m_box, row, 1, 1, formColumns - 1);
    connect(m_box, &QComboBox::activated, this,
            [this](int chosen) { choose(chosen == 0 ? RockIndexing::fresh : RockIndexing::same); });
}

void IndexingBox::present(const Scenario& scenario) {
    const QSignalBlocker quiet(m_box);
    m_box->setCurrentIndex(scenario.drill.indexing == RockIndexing::fresh ? 0 : 1);
}

void IndexingBox::choose(RockIndexing indexing) {
    Scenario changed = m_document.scenario();
    if (changed.drill.indexing == indexing) return;
    changed.drill.indexing = indexing;
    m_document.useScenario(changed, tr("change which rock the blows meet"));
    present(m_document.scenario());
}

}  // namespace drillwave
