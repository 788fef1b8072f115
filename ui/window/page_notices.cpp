// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/page_notices.h"

#include <QPushButton>

#include "core/model/section_words.h"
#include "core/model/string_edit.h"
#include "ui/text/shown_text.h"
#include "ui/window/page_tabs.h"

namespace drillwave {

ElsewhereNotice::ElsewhereNotice(PageTabs& pages, QWidget* parent)
    : Notice(Tone::information, parent),
      m_show(addButton(tr("Go there"), tr("Opens the page that has the answer"))) {
    setObjectName(QStringLiteral("elsewhere"));
    m_show->setObjectName(QStringLiteral("goThere"));
    connect(m_show, &QPushButton::clicked, this, [this] {
        if (m_page) emit m_page->elsewhereRequested();
    });
    connect(&pages, &PageTabs::absent, this, &ElsewhereNotice::tell);
    connect(&pages, &QStackedWidget::currentChanged, this, &QWidget::hide);
    connect(&pages, &PageTabs::offersChanged, this, [this, &pages] {
        if (m_page && pages.isOffered(pages.indexOf(m_page))) hide();
    });
}

void ElsewhereNotice::tell(Page* page) {
    m_page = page;
    m_show->setVisible(page->leadsElsewhere());
    say(page->elsewhere());
}

MarchedNotice::MarchedNotice(PageTabs& pages, QWidget* parent)
    : Notice(Tone::information, parent), m_pages(pages) {
    setObjectName(QStringLiteral("marchedBlow"));
    QPushButton* single = addButton(tr("Single blow"), tr("Shows the blow from rest again, as in Result"));
    single->setObjectName(QStringLiteral("singleBlow"));
    const auto leave = [this] {
        forget();
        emit singleWanted();
    };
    connect(single, &QPushButton::clicked, this, leave);
    connect(this, &Notice::dismissed, this, leave);
    connect(&pages, &QStackedWidget::currentChanged, this, &MarchedNotice::follow);
}

void MarchedNotice::open(const MarchedQuestion& blow, const QString& what) {
    m_blow = blow;
    setText(what);
    follow();
}

void MarchedNotice::forget() {
    m_blow.reset();
    hide();
}

std::optional<MarchedQuestion> MarchedNotice::blowOf(const Page& page) const {
    return page.showsMarched() ? m_blow : std::nullopt;
}

void MarchedNotice::follow() {
    setVisible(m_pages.count() > 0 && blowOf(m_pages.current()).has_value());
}

TakenNotice::TakenNotice(Document& document, QWidget* parent)
    : Notice(Tone::information, parent), m_document(document) {
    setObjectName(QStringLiteral("taken"));
    QPushButton* undo = addButton(tr("Undo"), tr("Undo this change"));
    undo->setObjectName(QStringLiteral("undoTaken"));
    connect(undo, &QPushButton::clicked, this, [this] {
        if (m_document.undoStack().index() == m_step) m_document.undoStack().undo();
    });
    connect(&document, &Document::stateChanged, this, [this] {
        if (m_document.undoStack().index() != m_step) hide();
    });
    connect(&document, &Document::replaced, this, &QWidget::hide);
}

void TakenNotice::follow(PageTabs& pages) {
    for (int index = 0; index < pages.count(); ++index) {
        const Page& page = pages.page(index);
        connect(&page, &Page::valuesTaken, this, [this, &page](const QString& what) {
            m_step = m_document.undoStack().index();
            say(tr("%1: %2.").arg(page.title(), what));
        });
    }
}

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
    const bool isThinned = blow.fault.isEmpty() && !blow.marchedBlow && !blow.pages.empty() &&
                           (!blow.impact.waves || blow.impact.wavesDifference);
    if (!isThinned || blow.request.scenario != m_document.scenario()) return hide();
    const DrillString rounded = withRoundedLengths(m_document.scenario().drillString);
    if (rounded == m_document.scenario().drillString) return hide();
    say(tr("This blow has too many waves to keep, so this page shows those of a coarser string. Rounding "
           "lengths to 10 mm can show them in full: %1.")
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
