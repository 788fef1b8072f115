// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/result_panel.h"

#include <QAction>
#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QSet>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "core/blow/feed_estimate.h"
#include "core/model/chain_words.h"
#include "core/report/sequence_words.h"
#include "core/study/drilling/sequence.h"
#include "ui/job/output_text.h"
#include "ui/result/alert_list.h"
#include "ui/result/event_table.h"
#include "ui/result/feed_text.h"
#include "ui/result/result_row.h"
#include "ui/text/lightness.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

// While values are dragged it would only take the time of the blows.
constexpr std::chrono::milliseconds sequenceRest{250};

const QString drillingLink = QStringLiteral("drilling");
const QString sequenceLink = QStringLiteral("follow");
const QString lossLink = QStringLiteral("loss");

bool isResolvedSequence(const DrillingResult& result) {
    const std::optional<Sequence> sequence = sequenceOf(result);
    return sequence && sequence->isResolved();
}

bool lacksWaveLoss(const DrillingResult& result) {
    const std::optional<Sequence> sequence = sequenceOf(result);
    return sequence && sequence->unresolved == UnresolvedReason::noWaveLoss;
}

/// Returns the words with the value inserted for %1, or nothing if there is no value.
QString withValue(const QString& words, const QString& value) {
    return value.isEmpty() ? QString() : words.arg(value);
}

}  // namespace

ShortSequence::ShortSequence(QObject* parent) : QObject(parent) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(sequenceRest);
    connect(&m_rest, &QTimer::timeout, this, &ShortSequence::start);
    connect(&m_job, &StudyActivity::changed, this, &ShortSequence::changed);
}

void ShortSequence::ask(const SolvedBlow& blow) {
    std::optional<Scenario> asked;
    if (blow.fault.isEmpty() && !blow.marched && blow.feed && blow.feed->force) {
        asked = blow.request.scenario;
        asked->title.clear();
    }
    if (asked == m_scenario) return;
    m_scenario = std::move(asked);
    m_job.cancel();
    m_isStarted = m_isDue = false;
    m_rest.stop();
    if (!m_scenario) return;
    if (!drillingRefusals(*m_scenario, windowSettingsOf(*m_scenario)).empty()) return m_scenario.reset();
    m_march = quickMarchOf(*m_scenario);
    m_isDue = m_march.isWithinTime;
    if (m_isDue) m_rest.start();
}

void ShortSequence::follow() {
    if (m_scenario && !m_isStarted) start();
}

void ShortSequence::start() {
    m_isDue = false;
    m_isStarted = true;
    m_job.submit(
        [scenario = *m_scenario, settings = m_march.settings](const StudyFeed<DrillingResult>& feed) {
            return studyDrilling(scenario, settings, quickWants(), feed.stop);
        });
}

const DrillingResult* ShortSequence::result() const {
    const bool isThere = m_scenario && m_isStarted && m_job.state() == StudyState::finished;
    return isThere && m_job.isCurrent() ? m_job.value().get() : nullptr;
}

bool ShortSequence::isAwaited() const {
    return m_scenario && (m_isDue || (m_isStarted && m_job.state() == StudyState::running));
}

std::optional<double> ShortSequence::secondsOnRequest() const {
    if (!m_scenario || m_isStarted || m_march.isWithinTime) return std::nullopt;
    return m_march.seconds;
}

ResultPanel::ResultPanel(QWidget* parent) : SteadyScrollArea(parent), m_veil(new StaleVeil(viewport())) {
    setWidget(new QWidget);
    auto* layout = new QVBoxLayout(widget());
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(6);
    addFeed();
    addHeadline();
    addAlerts();
    addNumbers(tr("Feed"), "feed",
               thrustEntries(m_worst, [this](const SolvedBlow& blow, UnitSystem) { return worstOf(blow); }));
    addEnergy();
    addNumbers(tr("Penetration"), "penetration", outputEntries(OutputGroup::penetration));
    addNumbers(tr("Rebound"), "rebound",
               QList<ResultEntry>{corEntry()} + outputEntries(OutputGroup::rebound));
    addNumbers(tr("Stress in the rod"), "stress", outputEntries(OutputGroup::stress));
    m_stress = m_rows.last().section();
    addNumbers(tr("Force and times"), "contact", outputEntries(OutputGroup::contact));
    addEvents();
    foldSections();
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
    connect(&m_sequence, &ShortSequence::changed, this, &ResultPanel::showFeed);
}

void ResultPanel::addEnergy() {
    addNumbers(tr("Energy"), "energy",
               QList<ResultEntry>{hammerEnergyEntry()} + outputEntries(OutputGroup::work) +
                   outputEntries(OutputGroup::share));
}

// The numbers a driller decides by, in one line below the bar of the energy.
void ResultPanel::addHeadline() {
    m_energy = new EnergyBar(widget());
    m_headline = new QLabel(widget());
    m_headline->setObjectName(QStringLiteral("headline"));
    m_headline->setWordWrap(true);
    m_headline->setAccessibleName(tr("penetration, energy, power and restitution"));
    makeSelectable(*m_headline);
    widget()->layout()->addWidget(m_energy);
    widget()->layout()->addWidget(m_headline);
}

void ResultPanel::showHeadline() {
    QStringList parts;
    if (m_blow->fault.isEmpty()) {
        const auto value = [this](std::string_view output) {
            return outputText(*findOutput(output), *m_blow);
        };
        parts << penetrationText();
        parts << withValue(tr("hammer work %1"), value("work_ratio"))
              << withValue(tr("power %1"), value("percussion_power"))
              << tr("e = %1").arg(value("cor")).replace(u' ', QChar(QChar::Nbsp));
        parts.removeAll(QString());
    }
    m_headline->setText(parts.join(QStringLiteral("  ·  ")));
}

QString ResultPanel::penetrationText() const {
    return withValue(tr("this blow: penetration %1"),
                     outputText(*findOutput("residual_penetration"), *m_blow));
}

QString ResultPanel::shortAnswer() const {
    if (!m_blow || !m_blow->fault.isEmpty()) return {};
    QStringList parts{m_required->text(), penetrationText()};
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

// Each section keeps its own state. Alerts begin open, numbers folded.
void ResultPanel::foldSections() {
    for (auto* section : widget()->findChildren<SectionBox*>(Qt::FindDirectChildrenOnly)) {
        const auto begin = section == m_alertSection ? SectionBox::Begin::open : SectionBox::Begin::folded;
        section->rememberAs(QStringLiteral("result/") + section->objectName(), begin);
    }
}

void ResultPanel::addAlerts() {
    m_alerts = new AlertList;
    m_alertSection = addSection(tr("Alerts"), "alerts");
    auto* layout = new QVBoxLayout(m_alertSection->content());
    layout->setContentsMargins(4, 0, 0, 0);
    layout->addWidget(m_alerts);
    connect(m_alerts, &AlertList::parameterChosen, this, &ResultPanel::parameterChosen);
}

// With room for the usual sentences, or the numbers below would move.
void ResultPanel::addFeed() {
    constexpr int lines = 2, linesBelow = 4;
    auto* feed = new QWidget(widget());
    m_required = new QLabel(feed);
    m_required->setObjectName(QStringLiteral("required"));
    m_required->setWordWrap(true);
    QFont font = m_required->font();
    font.setBold(true);
    m_required->setFont(font);
    m_required->setAccessibleName(tr("required feed"));
    makeSelectable(*m_required);
    m_followed = new QLabel(feed);
    m_followed->setObjectName(QStringLiteral("sequence"));
    m_followed->setWordWrap(true);
    m_followed->setTextFormat(Qt::RichText);
    m_followed->setAccessibleName(tr("sequence of blows"));
    m_followed->setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(m_followed, &QLabel::linkActivated, this, &ResultPanel::followLink);
    auto* layout = new QVBoxLayout(feed);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_required);
    layout->addWidget(m_followed);
    layout->addStretch();
    feed->setMinimumHeight(lines * QFontMetrics(font).lineSpacing() +
                           linesBelow * m_followed->fontMetrics().lineSpacing());
    widget()->layout()->addWidget(feed);
}

void ResultPanel::followLink(const QString& link) {
    if (link == drillingLink) emit drillingChosen();
    if (link == sequenceLink) m_sequence.follow();
    if (link == lossLink) emit waveLossWanted();
}

// Two lines, which are never merged: what single blows require, and what the sequence gives.
void ResultPanel::showFeed() {
    if (!m_blow) return;
    const FeedEstimateOnShow shown = estimateOnShow(m_worst, *m_blow);
    const DrillingResult* result = m_sequence.result();
    const bool isResolved = result && isResolvedSequence(*result);
    const bool isTooLittle = shown.estimate && shown.estimate->isTooLittle();
    const std::optional<FeedState> state = shown.estimate ? shown.estimate->state() : std::nullopt;
    const bool isMet = state == FeedState::requiredMet || state == FeedState::returnMet;
    const bool isGood = isMet && !shown.isAwaited && isResolved;
    const QString required = requiredText(shown, *m_blow);
    m_required->setText((isTooLittle ? QStringLiteral("⚠ ")
                         : isGood    ? QStringLiteral("✓ ")
                                     : QString()) +
                        required);
    setWarning(*m_required, isTooLittle);
    const bool isUnresolved = result && !isResolved;
    m_followed->setText(followedText(result));
    setWarning(*m_followed, isUnresolved);
    m_followed->setVisible(shown.estimate && shown.estimate->force);
    m_followed->parentWidget()->layout()->activate();
    widget()->layout()->activate();  // sentences of more lines have their room at once
    emit answered();
}

QString ResultPanel::followedText(const DrillingResult* result) const {
    const auto link = [](const QString& target, const QString& words) {
        return QStringLiteral("<a href=\"%1\">%2</a>").arg(target, words.toHtmlEscaped());
    };
    const QString page = link(drillingLink, tr("Drilling"));
    if (result) {
        QStringList words{
            translatedAll(sequenceSentences(*result, styleOf(m_blow->request))).toHtmlEscaped()};
        if (lacksWaveLoss(*result)) words << link(lossLink, tr("Set wave loss 10 %"));
        return (words << page).join(QLatin1Char(' '));
    }
    if (m_sequence.isAwaited()) return tr("Estimate from single blows. Consecutive blows are being solved …");
    if (const std::optional<double> seconds = m_sequence.secondsOnRequest())
        return tr("Estimate from single blows.") + QLatin1Char(' ') +
               link(sequenceLink, tr("Solve consecutive blows (about %1 s)")
                                      .arg(numberText(std::ceil(*seconds), 3, QLocale())));
    return tr("The required feed force is estimated from single blows; %1 solves consecutive blows.")
        .arg(page);
}

void ResultPanel::goToAlerts() {
    m_alertSection->setOpen(true);
    widget()->layout()->activate();
    ensureWidgetVisible(m_alertSection, 0, 0);
    m_alerts->takeFocus();
}

SectionBox* ResultPanel::addSection(const QString& title, const char* name) {
    auto* box = new SectionBox(title, widget());
    box->setObjectName(QLatin1String(name));
    widget()->layout()->addWidget(box);
    return box;
}

void ResultPanel::addNumbers(const QString& title, const char* name, const QList<ResultEntry>& entries) {
    SectionBox* section = addSection(title, name);
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
    auto* layout = new QVBoxLayout(addSection(tr("Events"), "events")->content());
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
    if (!m_required->text().isEmpty()) text += m_required->text() + QLatin1Char('\n');
    if (const DrillingResult* result = m_sequence.result())
        text += translatedAll(sequenceSentences(*result, styleOf(m_blow->request))) + QLatin1Char('\n');
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
    m_sequence.ask(*blow);
    showFeed();
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
    if (const QString title = translated(chainWords(blow->request.scenario).stresses);
        m_stress->title() != title) {
        m_stress->setTitle(title);
        updateGeometry();
    }
    m_alerts->present(blow->fault, blow->alerts, styleOf(blow->request));
    if (solved)
        m_energy->present(blow->summary);
    else
        m_energy->clear();
    showHeadline();
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
    showFeed();
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
