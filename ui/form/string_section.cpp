// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/string_section.h"

#include <QLocale>

#include "core/model/scales.h"
#include "core/model/section_words.h"
#include "ui/form/parameter_row.h"
#include "ui/text/shown_text.h"

namespace drillwave {

StringSection::StringSection(Document& document, QGridLayout* grid, QWidget* parent)
    : QObject(parent), m_document(document), m_summary(new QLabel(parent)) {
    m_summary->setObjectName(QStringLiteral("stringSummary"));
    m_summary->setWordWrap(true);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_summary->setToolTip(tr("Closed forms and groups are for uniform rods only"));
    auto* sections = new QPushButton(tr("Sections…"), parent);
    sections->setObjectName(QStringLiteral("sections"));
    sections->setToolTip(tr("The page String: a drawing, and all sections in a table to edit"));
    connect(sections, &QPushButton::clicked, this, &StringSection::sectionsRequested);
    const int row = grid->rowCount();
    grid->addWidget(m_summary, row, 0, 1, formColumns - 2);
    grid->addWidget(sections, row, formColumns - 2, 1, 2, Qt::AlignTop);
}

void StringSection::addRestrike(QGridLayout* grid, QWidget* parent) {
    m_restrike = new QCheckBox(tr("may strike again"), parent);
    m_restrike->setObjectName(QStringLiteral("hammer.restrike"));
    m_restrike->setAccessibleName(tr("Hammer: may strike again"));
    m_restrike->setToolTip(
        tr("The hammer stays where the string may meet it again; without it, it is withdrawn once they have "
           "parted"));
    grid->addWidget(m_restrike, grid->rowCount(), 0, 1, formColumns);
    connect(m_restrike, &QCheckBox::clicked, this, &StringSection::setRestrike);
}

void StringSection::setRestrike(bool restrike) {
    Scenario changed = m_document.scenario();
    changed.drillString.hammer.restrike = restrike;
    m_document.useScenario(changed, restrike ? tr("let the hammer strike again") : tr("withdraw the hammer"));
}

void StringSection::present(const Scenario& scenario) {
    const DrillString& drill = scenario.drillString;
    const ChainProperties string = stringProperties(drill);
    const auto text = [this](double si, UnitKind kind) { return m_document.units().text(si, kind, 4); };
    QString summary = QStringLiteral("%1, %2, %3")
                          .arg(translated(stringWords(drill)), text(string.length, UnitKind::length),
                               text(string.mass, UnitKind::mass));
    if (!isForced(scenario)) {
        const ChainProperties hammer = hammerProperties(drill);
        summary += tr("; hammer %1, %2")
                       .arg(text(hammer.length, UnitKind::length), text(hammer.mass, UnitKind::mass));
    }
    m_summary->setText(summary);
    m_restrike->setChecked(drill.hammer.restrike);
}

}  // namespace drillwave
