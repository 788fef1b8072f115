// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/result_panel.h"

#include <QAction>
#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QSet>
#include <QVBoxLayout>
#include <utility>

#include "core/model/blow_traits.h"
#include "ui/result/alert_link.h"
#include "ui/result/event_table.h"
#include "ui/result/feed_text.h"
#include "ui/result/output_text.h"
#include "ui/result/place_link.h"
#include "ui/result/result_entries.h"

namespace drillwave {

ResultPanel::ResultPanel(QWidget* parent) : SteadyScrollArea(parent), m_veil(new StaleVeil(viewport())) {
    setWidget(new QWidget);
    auto* layout = new QVBoxLayout(widget());
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(6);
    addNumbers(tr("Thrust"),
               thrustEntries(m_worst, [this](const SolvedBlow& blow, UnitSystem) { return worstOf(blow); }));
    addEnergy();
    addNumbers(tr("Penetration"), outputEntries(OutputGroup::penetration));
    addNumbers(tr("Rebound"), QList<ResultEntry>{corEntry()} + outputEntries(OutputGroup::rebound));
    addNumbers(tr("Stress in the rod"), outputEntries(OutputGroup::stress));
    m_stress = m_rows.last().section();
    addNumbers(tr("Force and times"), outputEntries(OutputGroup::contact));
    addEvents();
    addAlerts();
    addDecision();
    alignColumns();
    layout->addStretch();
    auto* copyAll = new QAction(tr("&Copy results"), this);
    copyAll->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R));
    copyAll->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(copyAll, &QAction::triggered, this, &ResultPanel::copy);
    addAction(copyAll);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    for (const WorstNeed* worst : {&m_worst, &m_worstOfReference})
        connect(worst, &WorstNeed::changed, this, &ResultPanel::showWorst);
}

// The shares stand under the bar that draws them.
void ResultPanel::addEnergy() {
    addNumbers(tr("Energy"), QList<ResultEntry>{hammerEnergyEntry()} + outputEntries(OutputGroup::work));
    SectionBox* section = m_rows.last().section();
    QGridLayout* grid = m_grids.last();
    m_energy = new EnergyBar(section->content());
    grid->addWidget(m_energy, grid->rowCount(), 0, 1, 4);
    for (const ResultEntry& entry : outputEntries(OutputGroup::share)) addRow(section, grid, entry);
}

void ResultPanel::addAlerts() {
    m_alerts = new AlertList;
    m_alertSection = addSection(tr("Alerts"));
    auto* layout = new QVBoxLayout(m_alertSection->content());
    layout->setContentsMargins(4, 0, 0, 0);
    layout->addWidget(m_alerts);
    connect(m_alerts, &AlertList::parameterChosen, this, &ResultPanel::parameterChosen);
    // The list is last, often below what can be seen: how long it is stands first, always in a row of its
    // own, or all the numbers would move.
    auto* link = new AlertLink(*m_alerts, AlertLink::WithoutAny::said, widget());
    connect(link, &QToolButton::clicked, this, &ResultPanel::goToAlerts);
    static_cast<QVBoxLayout*>(widget()->layout())->insertWidget(0, link, 0, Qt::AlignLeft);
}

// Before all numbers, with room for what it says at most, or they would move.
void ResultPanel::addDecision() {
    constexpr int lines = 4, linesBelow = 2;
    auto* decided = new QWidget(widget());
    m_decision = new QLabel(decided);
    m_decision->setObjectName(QStringLiteral("decision"));
    m_decision->setWordWrap(true);
    QFont font = m_decision->font();
    font.setBold(true);
    m_decision->setFont(font);
    m_decision->setAccessibleName(tr("what to do about the feed"));
    makeSelectable(*m_decision);
    m_beyond = new QLabel(decided);
    m_beyond->setObjectName(QStringLiteral("beyond"));
    m_beyond->setWordWrap(true);
    m_beyond->setText(tr("Told of single blows, each from rest; %1 follows one after another.")
                          .arg(QStringLiteral("<a href=\"drilling\">%1</a>").arg(tr("Drilling"))));
    m_beyond->setToolTip(
        tr("Waves that a blow leaves in the rod meet the next one, and may make the bit "
           "bounce where single blows say that it rests"));
    m_beyond->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    connect(m_beyond, &QLabel::linkActivated, this, &ResultPanel::drillingChosen);
    auto* layout = new QVBoxLayout(decided);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_decision);
    layout->addWidget(m_beyond);
    layout->addStretch();
    decided->setMinimumHeight(lines * QFontMetrics(font).lineSpacing() +
                              linesBelow * m_beyond->fontMetrics().lineSpacing());
    static_cast<QVBoxLayout*>(widget()->layout())->insertWidget(0, decided);
}

void ResultPanel::showDecision() {
    m_decision->setText(decisionText(m_worst, *m_blow));
    m_decision->setToolTip(m_blow->fault.isEmpty() ? feedMeaningText(*m_blow) : QString());
    m_beyond->setVisible(m_blow->feed && m_blow->feed->force);
}

void ResultPanel::goToAlerts() {
    m_alertSection->setOpen(true);
    widget()->layout()->activate();
    ensureWidgetVisible(m_alertSection, 0, 0);
    m_alerts->takeFocus();
}

SectionBox* ResultPanel::addSection(const QString& title) {
    auto* box = new SectionBox(title, widget());
    widget()->layout()->addWidget(box);
    return box;
}

void ResultPanel::addNumbers(const QString& title, const QList<ResultEntry>& entries) {
    SectionBox* section = addSection(title);
    QWidget* content = section->content();
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(4, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(1, 1);
    m_grids.append(grid);
    for (const ResultEntry& entry : entries) addRow(section, grid, entry);
}

void ResultPanel::addRow(SectionBox* section, QGridLayout* grid, const ResultEntry& entry) {
    m_rows.emplace_back(entry, section, grid);
    if (auto* link = qobject_cast<PlaceLink*>(m_rows.last().value()))
        connect(link, &PlaceLink::followed, this, [this, stress = entry.place] { follow(*stress); });
    m_rows.last().offer(Scenario());  // the panel is no wider than a rod needs
}

void ResultPanel::addEvents() {
    auto* layout = new QVBoxLayout(addSection(tr("Events"))->content());
    layout->setContentsMargins(4, 0, 0, 0);
    m_events = new EventTable(widget());
    layout->addWidget(m_events);
    connect(m_events, &EventTable::timeChosen, this, &ResultPanel::timeChosen);
}

// One set of columns through all sections, wide enough for every number: a panel whose width follows the
// values would jump while they are dragged.
void ResultPanel::alignColumns() {
    const QString widest = QStringLiteral("−88.88 kN (+8888 %)");
    const int value = fontMetrics().horizontalAdvance(widest);
    const int change = fontMetrics().horizontalAdvance(QStringLiteral("−88.8 kN"));
    for (QGridLayout* grid : std::as_const(m_grids)) {
        grid->setColumnMinimumWidth(2, change);
        grid->setColumnMinimumWidth(3, value);
    }
}

void ResultPanel::setTime(std::optional<double> time) {
    m_events->setTime(time);
}

void ResultPanel::setReference(const SolvedBlowPtr& blow, const QString& title) {
    m_reference = blow && blow->fault.isEmpty() ? blow : nullptr;
    m_referenceTitle = title;
    if (m_reference)
        m_worstOfReference.ask(*m_reference);
    else
        m_worstOfReference.askNothing();
    if (!m_blow) return;
    for (const ResultRow& row : std::as_const(m_rows)) showChange(row);
}

void ResultPanel::setOutOfDate(bool outOfDate) {
    m_veil->raise();
    m_veil->setVisible(outOfDate);
}

QString ResultPanel::text() const {
    QString text = m_veil->isHidden() ? QString() : StaleVeil::words() + QLatin1Char('\n');
    if (!m_decision->text().isEmpty()) text += m_decision->text() + QLatin1Char('\n');
    for (const ResultRow& row : m_rows)
        if (!row.section()->isHidden() && row.isThere()) text += row.text() + QLatin1Char('\n');
    return text;
}

void ResultPanel::copy() const {
    QGuiApplication::clipboard()->setText(text());
}

void ResultPanel::present(const SolvedBlowPtr& blow) {
    m_blow = blow;
    const bool solved = blow->fault.isEmpty();
    m_worst.ask(*blow);
    showDecision();
    QSet<SectionBox*> filled;
    for (const ResultRow& row : std::as_const(m_rows)) {
        row.offer(blow->request.scenario);
        showRow(row);
        if (row.isFilled()) filled.insert(row.section());
    }
    // Without frequency and feed force there is nothing to say about the thrust.
    for (const ResultRow& row : std::as_const(m_rows))
        row.section()->setVisible(!solved || filled.contains(row.section()));
    // The names of a string's numbers are longer than those of a rod's.
    if (const bool ofString = hasSections(blow->request.scenario);
        std::exchange(m_ofString, ofString) != ofString) {
        m_stress->setTitle(ofString ? tr("Stress in hammer and string") : tr("Stress in the rod"));
        updateGeometry();
    }
    m_alerts->present(blow->fault, blow->alerts, styleOf(blow->request));
    if (solved)
        m_energy->present(blow->summary);
    else
        m_energy->clear();
    m_events->present(blow);
}

void ResultPanel::showRow(const ResultRow& row) {
    row.present(*m_blow);
    showChange(row);
}

void ResultPanel::follow(const Output& stress) {
    if (!m_blow || !m_blow->fault.isEmpty()) return;
    if (const std::optional<RodForce> force = placeOf(stress, *m_blow))
        emit placeChosen(force->section, force->time);
}

void ResultPanel::showChange(const ResultRow& row) {
    row.presentChange(*m_blow, m_reference.get(), m_referenceTitle);
}

void ResultPanel::showWorst() {
    if (!m_blow) return;
    showDecision();
    for (const ResultRow& row : std::as_const(m_rows))
        if (row.entry().objectName == worstName) showRow(row);
}

// The pinned result may be the one on show.
std::optional<double> ResultPanel::worstOf(const SolvedBlow& blow) const {
    const WorstNeed& worst = &blow == m_blow.get() ? m_worst : m_worstOfReference;
    return worst.isCurrent() ? worst.thrust() : std::nullopt;
}

// The colour of warnings is another in a dark palette.
void ResultPanel::changeEvent(QEvent* event) {
    SteadyScrollArea::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) showWorst();
}

}  // namespace drillwave
