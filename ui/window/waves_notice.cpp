// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/waves_notice.h"

#include <QPushButton>

#include "core/model/blow_traits.h"
#include "core/model/section_words.h"
#include "core/model/string_edit.h"
#include "ui/text/shown_text.h"
#include "ui/window/page_tabs.h"

namespace drillwave {

WavesNotice::WavesNotice(Document& document, PageTabs& pages, QWidget* parent)
    : Notice(Tone::information, parent), m_document(document) {
    setObjectName(QStringLiteral("wavesNotice"));
    QPushButton* round = addButton(tr("Round the lengths"), tr("Round the lengths of all sections to 10 mm"));
    round->setObjectName(QStringLiteral("roundLengths"));
    connect(round, &QPushButton::clicked, this, [this] {
        Scenario changed = m_document.scenario();
        changed.drillString = withRoundedLengths(changed.drillString);
        if (const QString problem = m_document.useScenario(changed, tr("round the lengths"));
            !problem.isEmpty())
            say(problem);
    });
    connect(&document, &Document::scenarioChanged, this, &QWidget::hide);
    connect(&pages, &QStackedWidget::currentChanged, this, &QWidget::hide);
    hide();
}

void WavesNotice::present(const SolvedBlow& blow) {
    const bool isThinned = hasSections(blow.scenario) && blow.fault.isEmpty() && !blow.marchedBlow &&
                           !blow.pages.empty() && (!blow.impact.waves || blow.impact.wavesDifference);
    if (!isThinned || blow.request.scenario != m_document.scenario()) return hide();
    const DrillString rounded = withRoundedLengths(m_document.scenario().drillString);
    if (rounded == m_document.scenario().drillString) return hide();
    say(tr("The waves of this blow are too many to be kept: this page shows those of a coarser string. "
           "Rounding lengths to 10 mm can show them in full: %1.")
            .arg(changesText(rounded)));
}

// "hammer 1: 517 mm → 520 mm", of the first few.
QString WavesNotice::changesText(const DrillString& rounded) const {
    constexpr qsizetype mostChanges = 4;
    const DrillString& now = m_document.scenario().drillString;
    const std::vector<SectionSpot> spots = sectionSpots(now);
    const std::vector<Message> words = rowWords(now);
    const auto length = [this](double si) { return m_document.units().text(si, UnitKind::length, 4); };
    QStringList changes;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const double before = sectionAt(now, spots[i]).length, after = sectionAt(rounded, spots[i]).length;
        if (before == after) continue;
        if (changes.size() == mostChanges) {
            changes << QStringLiteral("…");
            break;
        }
        changes << QStringLiteral("%1: %2 → %3").arg(translated(words[i]), length(before), length(after));
    }
    return changes.join(QStringLiteral(", "));
}

}  // namespace drillwave
