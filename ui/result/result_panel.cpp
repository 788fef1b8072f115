// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/result/result_panel.h"

#include <QAction>
#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QScrollBar>
#include <QSet>
#include <QVBoxLayout>
#include <algorithm>
#include <string>
#include <utility>

#include "core/blow/thrust.h"
#include "ui/result/alert_link.h"
#include "ui/result/event_table.h"
#include "ui/result/feed_text.h"
#include "ui/result/output_text.h"
#include "ui/result/output_unit.h"
#include "ui/result/place_link.h"
#include "ui/runs/difference_text.h"
#include "ui/text/number_text.h"
#include "ui/text/warning_text.h"

namespace drillwave {
namespace {

// Its text can be selected; the menu is that of the panel.
void makeSelectable(QLabel& label) {
    label.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label.setContextMenuPolicy(Qt::NoContextMenu);
}

// Its swatch in the bar of the energy.
std::optional<EnergyPart> partOf(const Output& output) {
    if (output.name == "rock_work") return EnergyPart::rock;
    if (output.name == "rebound_energy") return EnergyPart::rebound;
    if (output.name == "residual_wave_energy") return EnergyPart::waves;
    if (output.name == "hammer_rebound_energy" || output.name == "hammer_wave_energy")
        return EnergyPart::hammer;
    if (output.name == "joint_loss" || output.name == "rod_loss" || output.name == "face_energy")
        return EnergyPart::losses;
    return std::nullopt;
}

// Of the values that are read first.
void makeHeavy(QLabel& label) {
    QFont font = label.font();
    font.setPointSizeF(font.pointSizeF() * 1.15);
    font.setBold(true);
    label.setFont(font);
}

const QString nothing = QStringLiteral("–");
const QString worstName = QStringLiteral("worstNeed");

// What studies of all gaps and the field of waves are there for.
bool isOfRod(const Scenario& scenario) {
    return !isString(scenario);
}

QString words(std::string_view text) {
    return ResultPanel::tr(std::string(text).c_str());
}

}  // namespace

ResultPanel::ResultPanel(QWidget* parent) : SteadyScrollArea(parent), m_veil(new StaleVeil(viewport())) {
    setWidget(new QWidget);
    auto* layout = new QVBoxLayout(widget());
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(6);
    addThrust();
    addEnergy();
    addPenetration();
    addRebound();
    addStress();
    addTimes();
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

ResultPanel::Number ResultPanel::numberOf(const Output& output) {
    if (output.measure == Measure::error) return nullptr;
    return
        [&output](const SolvedBlow& blow, UnitSystem units) { return comparableNumber(output, blow, units); };
}

QList<ResultPanel::Entry> ResultPanel::entriesOf(const std::function<bool(const Output&)>& wanted) const {
    QList<Entry> entries;
    for (const Output& output : outputs()) {
        if (output.group == OutputGroup::none || !wanted(output)) continue;
        entries.append({words(output.label), words(output.note),
                        [&output](const SolvedBlow& blow) { return outputText(output, blow); },
                        partOf(output)});
        entries.last().number = numberOf(output);
        entries.last().concerns = [&output](const Scenario& scenario) { return output.concerns(scenario); };
        entries.last().output = &output;
        if (!output.force) continue;
        entries.append({{},
                        tr("Where in the rod it is first that large, and when: a click leads there"),
                        [&output](const SolvedBlow& blow) { return placeText(output, blow); }});
        entries.last().place = &output;
        entries.last().concerns = [&output](const Scenario& scenario) { return output.concerns(scenario); };
    }
    return entries;
}

void ResultPanel::addThrust() {
    addNumbers(
        tr("Thrust"),
        {{tr("feed"),
          tr("What the feed force does between the blows"),
          feedText,
          {},
          feedMeaningText,
          Weight::usual},
         {tr("margin"),
          tr("Feed force less what this blow needs for full penetration, and as a share of that"),
          thrustMarginText,
          {},
          nullptr,
          Weight::usual,
          {},
          [](const SolvedBlow& blow, UnitSystem) { return thrustMargin(blow); },
          nullptr,
          [this](double now, double then) { return marginChangeText(now, then, *m_blow); }},
         {tr("needed"),
          tr("Thrust for full penetration, up to that which brings a bit that was at rest back before the "
             "next blow even if nothing damps, with the e of this blow"),
          thrustNeededText,
          {},
          nullptr,
          Weight::usual,
          {},
          [](const SolvedBlow& blow, UnitSystem) {
              return thrustNeeded(blow.scenario, blow.summary.cor, blow.summary.transferred);
          }},
         {tr("at every gap"),
          tr("The largest thrust for full penetration of this blow, of 95 % of all gaps, of a rigid rock, "
             "and of the worst gap on elastic rock"),
          [this](const SolvedBlow& blow) { return worstNeedText(m_worst, blow); },
          {},
          [this](const SolvedBlow&) { return m_worst.problem(); },
          Weight::usual,
          worstName,
          [this](const SolvedBlow& blow, UnitSystem) { return worstOf(blow); },
          nullptr,
          nullptr,
          nullptr,
          isOfRod},
         {{},
          tr("Feed force less the largest of the four needs, and as a share of that: thrust_margin of "
             "commands "
             "and files"),
          [this](const SolvedBlow& blow) { return worstMarginText(m_worst, blow); },
          {},
          nullptr,
          Weight::usual,
          worstName,
          nullptr,
          nullptr,
          nullptr,
          [this](const SolvedBlow& blow) { return isShortOfWorst(m_worst, blow); },
          isOfRod},
         {tr("installed"),
          tr("Feed force of the drill rig"),
          thrustInstalledText,
          {},
          nullptr,
          Weight::usual,
          {},
          [](const SolvedBlow& blow, UnitSystem) { return blow.scenario.drill.thrust; }}});
}

void ResultPanel::addEnergy() {
    // The power behind the work that it comes from.
    QList<Entry> first = entriesOf([](const Output& output) { return output.measure == Measure::work; });
    first += entriesOf([](const Output& output) { return output.measure == Measure::watt; });
    addNumbers(tr("Energy"), first);
    SectionBox* section = m_rows.last().section;
    QGridLayout* grid = m_grids.last();
    m_energy = new EnergyBar(section->content());
    grid->addWidget(m_energy, grid->rowCount(), 0, 1, 4);
    const auto isShare = [](const Output& output) {
        return output.group == OutputGroup::energy && output.measure != Measure::work &&
               output.measure != Measure::watt;
    };
    for (const Entry& entry : entriesOf(isShare)) addRow(section, grid, entry);
}

// What stays, before what is largest for a moment.
void ResultPanel::addPenetration() {
    QList<Entry> entries =
        entriesOf([](const Output& output) { return output.name == "residual_penetration"; });
    for (const Output& output : outputs())
        if (output.measure == Measure::speed && output.group == OutputGroup::impact) {
            entries.append({words(output.label), words(output.note), [&output](const SolvedBlow& blow) {
                                const QString text = outputText(output, blow);
                                return text.isEmpty() ? text : QStringLiteral("≤ ") + text;
                            }});
            entries.last().number = numberOf(output);
        }
    entries += entriesOf([](const Output& output) {
        return output.measure == Measure::penetration && output.name != "residual_penetration";
    });
    addNumbers(tr("Penetration"), entries);
}

void ResultPanel::addRebound() {
    Entry cor{tr("COR e"),
              tr("Coefficient of restitution: momentum after the blow over momentum before it, reversed, "
                 "e = −pf/p0"),
              [](const SolvedBlow& blow) { return numberText(blow.summary.cor, 4, QLocale()); },
              {},
              corErrorText,
              Weight::heavy,
              QStringLiteral("cor"),
              numberOf(*findOutput("cor"))};
    QList<Entry> entries{cor};
    for (const Output& output : outputs())
        if (output.measure == Measure::impulse && output.group == OutputGroup::impact) {
            entries.append({words(output.label), words(output.note),
                            [&output](const SolvedBlow& blow) { return impulseText(output, blow); }});
            entries.last().number = numberOf(output);
        }
    addNumbers(tr("Rebound"), entries);
}

void ResultPanel::addStress() {
    addNumbers(tr("Stress in the rod"),
               entriesOf([](const Output& output) { return output.group == OutputGroup::stress; }));
    m_stress = m_rows.last().section;
}

void ResultPanel::addTimes() {
    addNumbers(tr("Force and times"), entriesOf([](const Output& output) {
                   return output.group == OutputGroup::impact && output.measure != Measure::penetration &&
                          output.measure != Measure::speed && output.measure != Measure::impulse;
               }));
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
    constexpr int lines = 4;
    m_decision = new QLabel(widget());
    m_decision->setObjectName(QStringLiteral("decision"));
    m_decision->setWordWrap(true);
    m_decision->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    QFont font = m_decision->font();
    font.setBold(true);
    m_decision->setFont(font);
    m_decision->setMinimumHeight(lines * QFontMetrics(font).lineSpacing());
    m_decision->setAccessibleName(tr("what to do about the feed"));
    makeSelectable(*m_decision);
    static_cast<QVBoxLayout*>(widget()->layout())->insertWidget(0, m_decision);
}

void ResultPanel::showDecision() {
    m_decision->setText(decisionText(m_worst, *m_blow));
    m_decision->setToolTip(m_blow->fault.isEmpty() ? feedMeaningText(*m_blow) : QString());
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

void ResultPanel::addNumbers(const QString& title, const QList<Entry>& entries) {
    SectionBox* section = addSection(title);
    QWidget* content = section->content();
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(4, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(1, 1);
    m_grids.append(grid);
    for (const Entry& entry : entries) addRow(section, grid, entry);
}

void ResultPanel::addRow(SectionBox* section, QGridLayout* grid, const Entry& entry) {
    QWidget* content = section->content();
    auto* name = new QLabel(entry.name, content);
    auto* link = entry.place ? new PlaceLink(content) : nullptr;
    QLabel* value = link ? link : new QLabel(content);
    auto* change = new QLabel(content);
    change->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    change->hide();
    name->setToolTip(entry.meaning);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    if (link)
        connect(link, &PlaceLink::followed, this, [this, stress = entry.place] { follow(*stress); });
    else
        makeSelectable(*value);
    name->setBuddy(value);
    if (entry.weight == Weight::heavy) makeHeavy(*value);
    QWidget* swatch = nullptr;
    const int row = grid->rowCount();
    if (entry.name.isEmpty()) {
        name->hide();
        grid->addWidget(value, row, 1, 1, 3);
    } else if (entry.weight == Weight::heavy) {
        auto* line = new QHBoxLayout;
        line->addWidget(name);
        line->addStretch();
        line->addWidget(change);
        line->addSpacing(grid->horizontalSpacing());
        line->addWidget(value);
        grid->addLayout(line, row, 1, 1, 3);
    } else {
        if (entry.part) grid->addWidget(swatch = new EnergySwatch(*entry.part, content), row, 0);
        grid->addWidget(name, row, 1);
        grid->addWidget(change, row, 2);
        grid->addWidget(value, row, 3);
    }
    value->setObjectName(entry.objectName);
    m_rows.append({section, name, value, entry.meaning, entry.text, entry.note, entry.number,
                   entry.changeText ? entry.changeText : percentText, change, entry.warning, entry.concerns,
                   entry.output, swatch});
    offerRow(m_rows.last(), Scenario());  // the panel is no wider than a rod needs
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
    for (const Row& row : std::as_const(m_rows)) showChange(row);
}

void ResultPanel::setOutOfDate(bool outOfDate) {
    m_veil->raise();
    m_veil->setVisible(outOfDate);
}

QString ResultPanel::text() const {
    QString text = m_veil->isHidden() ? QString() : StaleVeil::words() + QLatin1Char('\n');
    if (!m_decision->text().isEmpty()) text += m_decision->text() + QLatin1Char('\n');
    for (const Row& row : m_rows)
        if (!row.section->isHidden() && row.isThere())
            text += row.section->title() + QStringLiteral(": ") + row.name->text() + QLatin1Char('\t') +
                    row.value->text() +
                    (row.change->text().isEmpty() ? QString() : QLatin1Char('\t') + row.change->text()) +
                    QLatin1Char('\n');
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
    for (const Row& row : std::as_const(m_rows)) {
        offerRow(row, blow->request.scenario);
        showRow(row);
        if (row.isThere() && row.value->text() != nothing) filled.insert(row.section);
    }
    // Without frequency and feed force there is nothing to say about the thrust.
    for (const Row& row : std::as_const(m_rows))
        row.section->setVisible(!solved || filled.contains(row.section));
    // The names of a string's numbers are longer than those of a rod's.
    if (const bool ofString = isString(blow->request.scenario);
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

// What a rod or a string alone has is not there for the other.
void ResultPanel::offerRow(const Row& row, const Scenario& scenario) {
    if (!row.concerns) return;
    const bool offered = row.concerns(scenario);
    row.name->setVisible(offered && !row.name->text().isEmpty());
    row.value->setVisible(offered);
    if (row.swatch) row.swatch->setVisible(offered);
}

void ResultPanel::showRow(const Row& row) {
    const bool solved = m_blow->fault.isEmpty();
    const QString text = solved ? row.text(*m_blow) : QString();
    row.value->setText(text.isEmpty() ? nothing : text);
    if (row.warning) setWarning(*row.value, solved && row.warning(*m_blow));
    const QString note = solved && row.note ? row.note(*m_blow) : QString();
    row.value->setToolTip(note.isEmpty() ? row.meaning : row.meaning + QStringLiteral(".\n") + note);
    // What has no name of its own goes on from the row above.
    row.value->setAccessibleName(row.name->text().isEmpty()
                                     ? row.value->text()
                                     : QStringLiteral("%1: %2").arg(row.name->text(), row.value->text()));
    showChange(row);
}

void ResultPanel::follow(const Output& stress) {
    if (!m_blow || !m_blow->fault.isEmpty()) return;
    if (const std::optional<RodForce> force = placeOf(stress, *m_blow))
        emit placeChosen(force->section, force->time);
}

void ResultPanel::showChange(const Row& row) {
    const UnitSystem units = m_blow->request.units;
    QString change;
    const bool isLike =
        m_reference && (!row.output || haveSameUnit(*row.output, *m_blow, *m_reference, units));
    if (isLike && row.number && row.isThere() && m_blow->fault.isEmpty()) {
        const std::optional<double> now = row.number(*m_blow, units);
        const std::optional<double> then = row.number(*m_reference, units);
        if (now && then) change = row.changeText(*now, *then);
    }
    row.change->setText(change);
    row.change->setVisible(!change.isEmpty());
    if (change.isEmpty()) return;
    row.change->setToolTip(tr("Off %1 by so much").arg(m_referenceTitle));
    row.change->setAccessibleName(
        tr("%1, against %2: %3").arg(row.name->text(), m_referenceTitle, row.change->text()));
}

void ResultPanel::showWorst() {
    if (!m_blow) return;
    showDecision();
    for (const Row& row : std::as_const(m_rows))
        if (row.value->objectName() == worstName) showRow(row);
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

QSize ResultPanel::sizeHint() const {
    const QSize content = widget()->sizeHint();
    return {content.width() + verticalScrollBar()->sizeHint().width() + 2, std::min(content.height(), 900)};
}

QSize ResultPanel::minimumSizeHint() const {
    return {std::max(widget()->minimumWidth(), widget()->minimumSizeHint().width()) +
                verticalScrollBar()->sizeHint().width() + 2,
            200};
}

}  // namespace drillwave
